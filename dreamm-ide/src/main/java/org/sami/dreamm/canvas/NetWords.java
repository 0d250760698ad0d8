package org.sami.dreamm.canvas;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.drawing.RequirementWords;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/** In which words an element of a plan is to be explained: what it is, and what is on it. */
final class NetWords {
    private NetWords() {}

    /** The words of an element; empty where the plan has it not, as with a note. */
    static Optional<String> of(Plan plan, String id) {
        return plan.place(id)
                .map(NetWords::place)
                .or(() -> plan.transition(id).map(NetWords::transition))
                .or(() -> plan.inEdges().stream()
                        .filter(edge -> edge.id().equals(id))
                        .findFirst()
                        .map(NetWords::edge))
                .or(() -> plan.outEdges().stream()
                        .filter(edge -> edge.id().equals(id))
                        .findFirst()
                        .map(NetWords::edge));
    }

    private static String place(Place place) {
        List<String> words = new ArrayList<>();
        words.add(place.start() ? "start place" : place.end() ? "end place" : "place");
        if (!place.outputs().isEmpty()) {
            words.add("output event");
        }
        if (!place.subMissions().isEmpty()) {
            words.add("sub-mission");
        }
        return String.join(" · ", words);
    }

    private static String transition(Transition transition) {
        return transition.inputs().isEmpty() ? "silent transition" : "transition · input event";
    }

    private static String edge(InEdge edge) {
        return edgeWith(edge.requirements().stream().map(RequirementWords::of).toList());
    }

    private static String edge(OutEdge edge) {
        return edgeWith(edge.requirements().stream().map(RequirementWords::of).toList());
    }

    private static String edgeWith(List<String> requirements) {
        return requirements.isEmpty() ? "edge" : "edge · requirement · " + String.join(" · ", requirements);
    }
}
