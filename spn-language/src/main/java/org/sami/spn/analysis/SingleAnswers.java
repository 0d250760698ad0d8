package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.TokenNeed;

/** Transitions that fire for one robot or task after the other, as each answers for itself: it arrives, or its timer runs down. */
final class SingleAnswers {
    private SingleAnswers() {}

    /** The places from which a transition takes one robot or task at a time, as each answers; empty where it fires for all together. */
    static List<Place> from(PlanContext plan, Transition t) {
        List<Place> places = new ArrayList<>();
        for (PlacedInput input : ofEach(plan, t)) {
            for (Place place : relevant(plan, t)) {
                if (plan.outputsOf(place).stream().anyMatch(o -> answersEach(o, input))) {
                    places.add(place);
                }
            }
        }
        return places;
    }

    /** The places from which robots or tasks come into a place one after the other. */
    static List<Place> comeSinglyFrom(PlanContext plan, String place) {
        return plan.place(place).map(plan::edgesInto).orElse(List.of()).stream()
                .flatMap(edge -> plan.transition(edge.transition()).stream())
                .flatMap(t -> from(plan, t).stream())
                .distinct()
                .toList();
    }

    /** Whether robots or tasks leave a place one after the other, as each answers or as there is news of it. */
    static boolean leave(PlanContext plan, Place place) {
        return plan.outTransitions(place).stream()
                .anyMatch(t -> from(plan, t).contains(place)
                        || (ofEach(plan, t).stream().anyMatch(SingleAnswers::isNews)
                                && relevant(plan, t).contains(place)));
    }

    /** The input event of a transition that fires for it alone, and for each of its occurrences. */
    private static List<PlacedInput> ofEach(PlanContext plan, Transition t) {
        List<PlacedInput> inputs = plan.inputsOf(t);
        boolean alone =
                t.waitFor() == WaitFor.EACH && inputs.size() == 1 && t.inputs().size() == 1;
        return alone ? inputs : List.of();
    }

    /** The places that must hold the tokens that the event names. */
    private static List<Place> relevant(PlanContext plan, Transition t) {
        return plan.inEdges(t).stream()
                .filter(SingleAnswers::isRelevant)
                .flatMap(edge -> plan.place(edge.place()).stream())
                .toList();
    }

    /** Whether an event comes of each by itself, without having been asked for. */
    private static boolean isNews(PlacedInput input) {
        return input.type().flags().contains(EventFlag.NEWS) && input.type().tokens() != TokenNeed.NONE;
    }

    private static boolean isRelevant(InEdge edge) {
        return edge.requirements().stream().anyMatch(r -> r.kind() == TokenKind.RELEVANT);
    }

    private static boolean answersEach(PlacedOutput output, PlacedInput input) {
        Set<EventFlag> flags = output.type().flags();
        boolean each = flags.contains(EventFlag.COMMAND)
                || output.type().role() == EventRole.PROXY_TIMER
                || input.type().flags().contains(EventFlag.NEWS);
        boolean names = input.type().tokens() != TokenNeed.NONE || input.type().role() == EventRole.PROXY_TIMER_EXPIRED;
        return each && names && output.type().answers().contains(input.type().name());
    }
}
