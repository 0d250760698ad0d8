package org.sami.spn.analysis;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.vocabulary.TokenNeed;

/**
 * An output event that needs proxies or tasks stands where some edge can bring them (thesis 4.3.3, Token Requirements). An
 * allocated task brings its proxy. Where an unconditional edge enters, nobody was meant to come: that is a warning.
 */
final class TokensForOutputs implements PlanCheck {
    private static final Set<TokenKind> BRING_TASKS = EnumSet.of(
            TokenKind.ANY_TASK, TokenKind.TASK, TokenKind.ANY_TOKEN, TokenKind.RELEVANT, TokenKind.SUB_MISSION_TOKENS);
    private static final Set<TokenKind> BRING_PROXIES = EnumSet.of(
            TokenKind.ANY_PROXY,
            TokenKind.ANY_TASK,
            TokenKind.TASK,
            TokenKind.ANY_TOKEN,
            TokenKind.RELEVANT,
            TokenKind.SUB_MISSION_TOKENS);

    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        "E-NO-TOKENS",
                        "The event commands robots or tasks, and none can come to its place: nobody is commanded.",
                        "Lead robots or tasks to the place, or move the event to a place where they are."),
                new Advice(
                        "W-NO-TOKENS",
                        "The place can be entered with nobody in it: the event then commands nobody.",
                        "Let an edge bring robots or tasks to the place."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedOutput output : plan.outputs()) {
            TokenNeed need = output.type().tokens();
            if (need == TokenNeed.NONE || output.place().start()) {
                continue;
            }
            List<OutRequirement> entering = plan.edgesInto(output.place()).stream()
                    .flatMap(e -> e.requirements().stream())
                    .filter(r -> r.action() != Action.CONSUME)
                    .toList();
            Set<TokenKind> useful = need == TokenNeed.TASK ? BRING_TASKS : BRING_PROXIES;
            if (!entering.isEmpty() && entering.stream().noneMatch(r -> useful.contains(r.kind()))) {
                boolean byNobody = entering.stream().anyMatch(r -> r.kind() == TokenKind.UNCONDITIONAL);
                String what = need == TokenNeed.TASK ? "tasks" : "proxies";
                String message = plan.name(output) + " needs " + what + ", but no edge brings any there";
                report.accept(
                        byNobody
                                ? Finding.warning("W-NO-TOKENS", output.pointer(), message, ids(output))
                                : Finding.error("E-NO-TOKENS", output.pointer(), message, ids(output)));
            }
        }
    }

    private static String[] ids(PlacedOutput output) {
        return new String[] {output.place().id(), output.spec().id()};
    }
}
