package org.sami.spn.analysis;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;

/**
 * Who enters a place when its shared instance is over stays there. An instance is over when it has entered an end place that ends
 * it; a place can be entered after that when something on the way to it can happen more than once.
 */
final class SharedInstancesOver implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-SHARED-OVER",
                "The shared sub-mission is over by then: who enters the place later is never brought back.",
                "Lead them elsewhere once it is over, or let the sub-mission not end its shared instance."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Place place : plan.plan().places()) {
            for (int i = 0; i < place.subMissions().size(); i++) {
                SubMissionSpec spec = place.subMissions().get(i);
                Optional<Place> ending =
                        spec.shared() ? plan.child(spec).flatMap(SharedInstancesOver::ending) : Optional.empty();
                if (ending.isPresent() && canBeEnteredAgain(plan, place)) {
                    report.accept(Finding.warning(
                            "W-SHARED-OVER",
                            plan.at(place) + "/subMissions/" + i,
                            "The " + plan.name(place) + " can be entered when the shared instance of \""
                                    + spec.plan()
                                    + "\" is over, which its " + plan.name(ending.get())
                                    + " ends: nobody brings back who enters then",
                            spec.id()));
                }
            }
        }
    }

    /** An end place that ends the shared instance, and to which something leads. */
    static Optional<Place> ending(Plan child) {
        return child.places().stream()
                .filter(p -> p.end()
                        && p.endsSharedInstance()
                        && child.outEdges().stream().anyMatch(e -> e.place().equals(p.id())))
                .findFirst();
    }

    private static boolean canBeEnteredAgain(PlanContext plan, Place place) {
        List<String> into = plan.edgesInto(place).stream()
                .map(OutEdge::transition)
                .distinct()
                .toList();
        return into.size() > 1 || canRepeat(plan, place);
    }

    /** Whether on some way to a place stands a transition that fires more than once, or the place itself. */
    private static boolean canRepeat(PlanContext plan, Place place) {
        Set<String> singleAnswers = singleAnswers(plan);
        Set<Place> seen = new HashSet<>();
        Deque<Place> open = new ArrayDeque<>(List.of(place));
        while (!open.isEmpty()) {
            for (OutEdge edge : plan.edgesInto(open.pop())) {
                Optional<Transition> t = plan.transition(edge.transition());
                if (t.isPresent() && repeats(plan, t.get(), singleAnswers)) {
                    return true;
                }
                for (Place before : t.map(plan::inPlaces).orElse(List.of())) {
                    if (before.equals(place)) {
                        return true;
                    }
                    if (seen.add(before)) {
                        open.push(before);
                    }
                }
            }
        }
        return false;
    }

    private static boolean repeats(PlanContext plan, Transition t, Set<String> singleAnswers) {
        if (t.inputs().isEmpty()) {
            return plan.outEdges(t).stream()
                    .flatMap(e -> e.requirements().stream())
                    .anyMatch(SharedInstancesOver::takesSome);
        }
        boolean single = plan.inputsOf(t).stream()
                .anyMatch(i -> singleAnswers.contains(i.type().name()));
        return !single && t.waitFor() == WaitFor.EACH;
    }

    private static boolean takesSome(OutRequirement r) {
        return !r.takesAll() && r.kind() != TokenKind.GENERIC && r.kind() != TokenKind.UNCONDITIONAL;
    }

    /** Input events that come once for what was asked: answers of the operator, of a clock and of the engine. */
    private static Set<String> singleAnswers(PlanContext plan) {
        Set<String> names = new HashSet<>();
        for (EventType type : plan.vocabulary().events().values()) {
            Optional<DecisionType> decision = type.decision();
            decision.ifPresent(d -> Stream.of(d.accepted(), d.rejected()).forEach(names::add));
            if (comesOnce(type.role())) {
                names.add(type.name());
            }
        }
        return names;
    }

    private static boolean comesOnce(EventRole role) {
        return switch (role) {
            case TIMER_EXPIRED, TOKENS_RETURNED, TASKS_GENERATED, ABORT_RECEIVED, COMPLETE_RECEIVED -> true;
            default -> false;
        };
    }
}
