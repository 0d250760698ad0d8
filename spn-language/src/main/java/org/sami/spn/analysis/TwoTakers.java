package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventRole;

/**
 * Of two transitions after one place that wait for the same event, one asks for something that the other does not: else the one that is
 * looked at first takes the tokens that both require, and the other fires for nobody. Interrupts of one name are {@link InterruptNames}' business.
 */
final class TwoTakers implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-TWO-TAKERS",
                "The transition that is looked at first takes every answer: the other never fires.",
                "Let the two wait for different answers or ask for different tokens, or draw one transition."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        Set<String> told = new HashSet<>();
        for (Place place : plan.plan().places()) {
            List<Transition> takers = inOrder(plan, place);
            for (int i = 0; i < takers.size(); i++) {
                for (int j = i + 1; j < takers.size(); j++) {
                    Transition first = takers.get(i);
                    Transition second = takers.get(j);
                    if (sameEvent(plan, first, second)
                            && takesAll(plan, place, first, second)
                            && told.add(first.id() + " " + second.id())) {
                        report(plan, place, first, second, report);
                    }
                }
            }
        }
    }

    private static List<Transition> inOrder(PlanContext plan, Place place) {
        Set<Transition> order = new LinkedHashSet<>();
        List<Transition> all = plan.outTransitions(place);
        place.transitionOrder()
                .forEach(id -> all.stream().filter(t -> t.id().equals(id)).forEach(order::add));
        order.addAll(all);
        return new ArrayList<>(order);
    }

    private static boolean sameEvent(PlanContext plan, Transition first, Transition second) {
        List<PlacedInput> one = plan.inputsOf(first);
        List<PlacedInput> other = plan.inputsOf(second);
        return one.size() == 1
                && other.size() == 1
                && first.inputs().size() == 1
                && second.inputs().size() == 1
                && one.get(0).type().equals(other.get(0).type())
                && one.get(0).type().role() != EventRole.INTERRUPT
                && one.get(0).spec().fields().equals(other.get(0).spec().fields());
    }

    /** Whether the first fires whenever the second can, and leaves no token that the second requires. */
    private static boolean takesAll(PlanContext plan, Place place, Transition first, Transition second) {
        Set<Condition> wanted = conditions(plan, second);
        boolean relevant = speaksOfRelevant(plan, first);
        return wanted.containsAll(conditions(plan, first))
                && relevant == speaksOfRelevant(plan, second)
                && first.waitFor() == second.waitFor()
                && wanted.stream()
                        .filter(c -> c.place().equals(place.id()) && wants(c.requirement()))
                        .anyMatch(c -> plan.outEdges(first).stream()
                                .flatMap(e -> e.requirements().stream())
                                .anyMatch(r -> takes(r, c.requirement().kind())));
    }

    private static boolean wants(InRequirement r) {
        return r.match() == Match.ALL || (r.match() == Match.AT_LEAST && r.n() == 1);
    }

    private static boolean takes(OutRequirement r, TokenKind kind) {
        boolean covers = r.kind() == kind || r.kind() == TokenKind.ANY_TOKEN;
        return r.action() != Action.ADD && covers;
    }

    private static boolean speaksOfRelevant(PlanContext plan, Transition t) {
        return plan.outEdges(t).stream()
                .flatMap(e -> e.requirements().stream())
                .anyMatch(r -> r.kind() == TokenKind.RELEVANT);
    }

    private static Set<Condition> conditions(PlanContext plan, Transition t) {
        Set<Condition> conditions = new LinkedHashSet<>();
        for (InEdge edge : plan.inEdges(t)) {
            edge.requirements().stream()
                    .filter(r -> r.kind() != TokenKind.UNCONDITIONAL)
                    .forEach(r -> conditions.add(new Condition(edge.place(), r)));
        }
        return conditions;
    }

    private static void report(
            PlanContext plan, Place place, Transition first, Transition second, Consumer<Finding> report) {
        report.accept(Finding.warning(
                "W-TWO-TAKERS",
                plan.at(second),
                plan.transitionName(second.id()) + " waits in the " + plan.name(place) + " for the same "
                        + plan.inputsOf(second).get(0).type().title() + " as the " + plan.name(first)
                        + ", which is looked at first and takes all: let the two ask for different things, or draw one",
                second.id(),
                first.id(),
                place.id()));
    }

    private record Condition(String place, InRequirement requirement) {}
}
