package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventFlag;

/**
 * One robot gets one command at a time: of two commands on one place, or in two places that one firing brings it to, the later one waits
 * or takes the place of the other. Commands without an answer, which withdraw others, do not count.
 */
final class TwoCommands implements PlanCheck {
    private static final String CODE = "W-TWO-COMMANDS";

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                CODE,
                "The robot gets the second command while it carries out the first, which is broken off.",
                "Put the second command on a place after the first, behind a transition that waits until it "
                        + "is done."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Place place : plan.plan().places()) {
            List<PlacedOutput> commands = commands(plan, place);
            if (commands.size() > 1) {
                report.accept(Finding.warning(
                        CODE,
                        commands.get(1).pointer(),
                        commands.get(0).type().title() + " and "
                                + commands.get(1).type().title() + " at the " + plan.name(place)
                                + " command the same robots at once: give the second in a place that follows when the"
                                + " first is done",
                        place.id(),
                        commands.get(0).spec().id(),
                        commands.get(1).spec().id()));
            }
        }
        for (Transition t : plan.plan().transitions()) {
            forks(plan, t, report);
        }
    }

    private static List<PlacedOutput> commands(PlanContext plan, Place place) {
        return plan.outputsOf(place).stream()
                .filter(o -> o.type().flags().contains(EventFlag.COMMAND)
                        && !o.type().answers().isEmpty())
                .toList();
    }

    private static void forks(PlanContext plan, Transition t, Consumer<Finding> report) {
        List<OutEdge> commanded = new ArrayList<>();
        for (OutEdge edge : plan.outEdges(t)) {
            Optional<Place> place = plan.place(edge.place());
            if (place.isPresent() && !commands(plan, place.get()).isEmpty()) {
                commanded.add(edge);
            }
        }
        for (int i = 1; i < commanded.size(); i++) {
            OutEdge first = commanded.get(0);
            OutEdge second = commanded.get(i);
            if (!first.place().equals(second.place()) && meet(plan, first, second)) {
                report.accept(Finding.warning(
                        CODE,
                        plan.at(second),
                        plan.transitionName(t.id()) + " brings the same robots into the "
                                + plan.placeName(first.place()) + " and the " + plan.placeName(second.place())
                                + ", which both command them: lead each robot into one of them",
                        second.id(),
                        first.id(),
                        t.id()));
            }
        }
    }

    /** Whether two edges bring a copy of one token with a name each. */
    private static boolean meet(PlanContext plan, OutEdge first, OutEdge second) {
        for (TokenType kind : Set.of(TokenType.PROXY, TokenType.TASK)) {
            if (brings(plan, first, kind) && brings(plan, second, kind)) {
                return true;
            }
        }
        return false;
    }

    private static boolean brings(PlanContext plan, OutEdge edge, TokenType kind) {
        return plan.flow().along(edge).contains(kind)
                && edge.requirements().stream()
                        .anyMatch(r -> r.action() != Action.CONSUME
                                && r.kind() != TokenKind.TASK
                                && TokenType.of(r.kind()).contains(kind));
    }
}
