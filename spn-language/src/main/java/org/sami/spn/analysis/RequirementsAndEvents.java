package org.sami.spn.analysis;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.TokenNeed;

/** A transition whose input events name proxies or tasks does something with them (thesis 4.3.3, Token Requirements). */
final class RequirementsAndEvents implements PlanCheck {
    private static final Set<TokenKind> NOT_ABOUT_ANYBODY = EnumSet.of(TokenKind.GENERIC, TokenKind.UNCONDITIONAL);

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-NAMED-IGNORED",
                "The event says which robots or tasks it is about, but the transition moves others or none of"
                        + " them.",
                "Speak of relevant tokens in the requirements of its edges."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Transition t : plan.plan().transitions()) {
            List<PlacedInput> naming = plan.inputsOf(t).stream()
                    .filter(i -> i.type().tokens() != TokenNeed.NONE)
                    .toList();
            Stream<TokenKind> in = plan.inEdges(t).stream()
                    .flatMap(e -> e.requirements().stream())
                    .map(InRequirement::kind);
            Stream<TokenKind> out = plan.outEdges(t).stream()
                    .flatMap(e -> e.requirements().stream())
                    .map(OutRequirement::kind);
            List<TokenKind> kinds = Stream.concat(in, out).toList();
            if (!naming.isEmpty() && !kinds.isEmpty() && NOT_ABOUT_ANYBODY.containsAll(kinds)) {
                report.accept(Finding.warning(
                        "W-NAMED-IGNORED",
                        plan.at(t),
                        "The " + plan.name(t) + " waits for "
                                + naming.get(0).type().title()
                                + ", which names proxies or tasks, but none of its requirements speaks of them",
                        t.id()));
            }
        }
    }
}
