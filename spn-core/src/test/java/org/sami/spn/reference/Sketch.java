package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The places of a random plan and what they do, before its transitions are drawn. The last places are its end places. */
final class Sketch {
    final int places;
    final int ends;
    final boolean isChild;
    /** Whether tasks will be there, of the plan itself or of those that run it. */
    final boolean hasTasks;
    /** Types of the output events, by place. */
    final Map<String, List<String>> outputs = new LinkedHashMap<>();
    /** Plans that may run as sub-missions. */
    final List<String> children;
    /** Places with dynamic sub-missions. */
    final Set<String> dynamic = new LinkedHashSet<>();
    /** Places with static sub-missions. */
    final Set<String> shared = new LinkedHashSet<>();
    /** Places with two sub-missions at once. */
    final Set<String> twoAtOnce = new LinkedHashSet<>();

    Sketch(int places, int ends, boolean isChild, List<String> children, boolean hasTasks) {
        this.places = places;
        this.ends = ends;
        this.isChild = isChild;
        this.children = children;
        this.hasTasks = hasTasks;
        for (int i = 0; i < places; i++) {
            outputs.put(name(i), new ArrayList<>());
        }
    }

    static String name(int place) {
        return "p" + place;
    }

    /** How many places are no end places. */
    int inner() {
        return places - ends;
    }

    boolean isEnd(int place) {
        return place >= inner();
    }

    boolean hasSub(String place) {
        return dynamic.contains(place) || shared.contains(place);
    }
}
