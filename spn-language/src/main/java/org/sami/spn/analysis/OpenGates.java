package org.sami.spn.analysis;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;

/**
 * A place that does nothing, into which robots or tasks come one after the other from one place, gathers them: the transition behind it
 * waits for more than the first. One that asks only for at least 1 lets each go on as it comes.
 */
final class OpenGates implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-OPEN-GATE",
                "The place is to gather them, but the first goes on alone.",
                "Let the transition also ask for none (= 0) in the place from which they come, or leave the "
                        + "gathering place out."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Transition t : plan.plan().transitions()) {
            List<InEdge> edges = plan.inEdges(t);
            if (t.inputs().isEmpty()
                    && edges.size() == 1
                    && plan.outPlaces(t).stream().noneMatch(Place::end)) {
                InEdge edge = edges.get(0);
                plan.place(edge.place())
                        .filter(place -> doesNothing(place)
                                && plan.edgesInto(place).size() == 1
                                && nobodyElseTakes(plan, place, t))
                        .ifPresent(place -> check(plan, t, edge, place, report));
            }
        }
    }

    private static boolean doesNothing(Place place) {
        return !place.start()
                && place.outputs().isEmpty()
                && place.subMissions().isEmpty();
    }

    /** Whether the other transitions after a place wait for an event, or only ask that nobody is there. */
    private static boolean nobodyElseTakes(PlanContext plan, Place place, Transition t) {
        return plan.plan().inEdges().stream()
                .filter(e -> e.place().equals(place.id()) && !e.transition().equals(t.id()))
                .filter(e -> plan.transition(e.transition())
                        .filter(other -> other.inputs().isEmpty())
                        .isPresent())
                .allMatch(e ->
                        !e.requirements().isEmpty() && e.requirements().stream().allMatch(InRequirement::asksForNone));
    }

    private static void check(PlanContext plan, Transition t, InEdge edge, Place place, Consumer<Finding> report) {
        List<Place> before = SingleAnswers.comeSinglyFrom(plan, place.id());
        boolean firstGoesOn =
                edge.requirements().size() == 1 && edge.requirements().stream().allMatch(OpenGates::asksForOne);
        if (firstGoesOn && !before.isEmpty()) {
            Set<TokenType> kinds = TokenType.of(edge.requirements().get(0).kind());
            report.accept(ForgottenPlaces.askingForNone(
                    plan,
                    t,
                    before,
                    kinds,
                    Finding.warning(
                            "W-OPEN-GATE",
                            plan.at(t),
                            plan.transitionName(t.id()) + " lets the first in the " + plan.name(place)
                                    + " go on at once, while others may be in the " + plan.name(before.get(0))
                                    + ". To go on together, ask for none left (= 0) there as well; else leave out the "
                                    + plan.name(place),
                            t.id(),
                            place.id())));
        }
    }

    private static boolean asksForOne(InRequirement r) {
        Set<TokenType> kinds = TokenType.of(r.kind());
        return r.match() == Match.AT_LEAST
                && r.n() <= 1
                && (kinds.contains(TokenType.PROXY) || kinds.contains(TokenType.TASK));
    }
}
