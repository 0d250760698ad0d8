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

    /** The places from which a transition takes one robot or task at a time; empty where it fires for all together. */
    static List<Place> from(PlanContext plan, Transition t) {
        List<PlacedInput> inputs = plan.inputsOf(t);
        if (t.waitFor() != WaitFor.EACH || inputs.size() != 1 || t.inputs().size() != 1) {
            return List.of();
        }
        PlacedInput input = inputs.get(0);
        List<Place> places = new ArrayList<>();
        for (InEdge edge : plan.inEdges(t)) {
            plan.place(edge.place())
                    .filter(place -> isRelevant(edge))
                    .filter(place ->
                            isNews(input) || plan.outputsOf(place).stream().anyMatch(o -> answersEach(o, input)))
                    .ifPresent(places::add);
        }
        return places;
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
        boolean each = flags.contains(EventFlag.COMMAND) || output.type().role() == EventRole.PROXY_TIMER;
        boolean names = input.type().tokens() != TokenNeed.NONE || input.type().role() == EventRole.PROXY_TIMER_EXPIRED;
        return each && names && output.type().answers().contains(input.type().name());
    }
}
