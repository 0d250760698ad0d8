package org.sami.spn.analysis;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventFlag;

/** The news that all is well takes no robot from its work: it comes at once, of each healthy robot ({@link EventFlag#NOMINAL}). */
final class HealthyLedAway implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-HEALTHY-LED-AWAY",
                "Good news comes again and again: each time a robot that works well is taken from its " + "command.",
                "Wait for the news that the robot is not well."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedInput input : plan.inputs()) {
            if (input.type().flags().contains(EventFlag.NOMINAL)) {
                Transition t = input.transition();
                workBefore(plan, t)
                        .filter(work -> leadsAway(plan, t, work))
                        .ifPresent(work -> report.accept(Finding.warning(
                                "W-HEALTHY-LED-AWAY",
                                input.pointer(),
                                input.type().title() + " says that a robot is well, and the " + plan.name(t)
                                        + " takes it from its command in the " + plan.name(work)
                                        + ": wait for the news that it is not well instead",
                                t.id(),
                                input.spec().id(),
                                work.id())));
            }
        }
    }

    /** A place before a transition in which robots carry out a command. */
    private static Optional<Place> workBefore(PlanContext plan, Transition t) {
        for (InEdge edge : plan.inEdges(t)) {
            Optional<Place> place = plan.place(edge.place());
            boolean works = place.isPresent()
                    && plan.outputsOf(place.get()).stream()
                            .anyMatch(o -> o.type().flags().contains(EventFlag.COMMAND)
                                    && !o.type().flags().contains(EventFlag.ANSWER_OPTIONAL)
                                    && !o.type().answers().isEmpty());
            if (works) {
                return place;
            }
        }
        return Optional.empty();
    }

    private static boolean leadsAway(PlanContext plan, Transition t, Place work) {
        for (OutEdge edge : plan.outEdges(t)) {
            if (!edge.place().equals(work.id()) && edge.requirements().stream().anyMatch(HealthyLedAway::takesRobots)) {
                return true;
            }
        }
        return false;
    }

    private static boolean takesRobots(OutRequirement r) {
        return r.action() != Action.ADD
                && (r.kind() == TokenKind.RELEVANT || TokenType.of(r.kind()).contains(TokenType.PROXY));
    }
}
