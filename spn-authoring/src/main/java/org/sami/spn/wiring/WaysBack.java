package org.sami.spn.wiring;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Plan;

/** What comes before a place on the ways of its plan, and how many firings before. An edge that only asks for zero is no way. */
public final class WaysBack {
    private final Map<String, Integer> transitions = new LinkedHashMap<>();
    private final Map<String, Integer> places = new LinkedHashMap<>();

    /** The ways back from a place of a plan. */
    public WaysBack(Plan plan, String place) {
        Deque<String> open = new ArrayDeque<>(List.of(place));
        places.put(place, 0);
        while (!open.isEmpty()) {
            String at = open.remove();
            int steps = Objects.requireNonNull(places.get(at), at) + 1;
            for (OutEdge edge : plan.outEdges()) {
                if (edge.place().equals(at) && transitions.putIfAbsent(edge.transition(), steps) == null) {
                    for (InEdge before : plan.inEdgesOf(edge.transition())) {
                        if (isWay(before) && places.putIfAbsent(before.place(), steps) == null) {
                            open.add(before.place());
                        }
                    }
                }
            }
        }
    }

    /** Whether tokens, or nobody, go through an edge. */
    public static boolean isWay(InEdge edge) {
        return edge.requirements().isEmpty() || edge.requirements().stream().anyMatch(r -> r.match() != Match.ZERO);
    }

    /** The transitions before the place with the least number of firings to it, nearest first; 1 is the one that enters it. */
    public Map<String, Integer> transitions() {
        return Collections.unmodifiableMap(transitions);
    }

    /** The places before it in the same way, nearest first; the place itself has 0. */
    public Map<String, Integer> places() {
        return Collections.unmodifiableMap(places);
    }
}
