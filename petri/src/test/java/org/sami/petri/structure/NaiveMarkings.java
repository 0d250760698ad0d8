package org.sami.petri.structure;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.sami.petri.net.PetriNet;

/** Reachable markings by a search without any art: lists in a hash set, and a firing rule of its own. */
public final class NaiveMarkings {
    private final PetriNet net;
    private final Set<List<Integer>> found = new LinkedHashSet<>();
    private final boolean complete;

    /** Searches until so many markings are found. */
    public NaiveMarkings(PetriNet net, int most) {
        this.net = net;
        Deque<List<Integer>> open = new ArrayDeque<>();
        List<Integer> initial = new ArrayList<>();
        for (int place = 0; place < net.placeCount(); place++) {
            initial.add(net.initial(place));
        }
        found.add(initial);
        open.add(initial);
        while (!open.isEmpty() && found.size() < most) {
            List<Integer> marking = open.remove();
            for (int transition = 0; transition < net.transitionCount(); transition++) {
                if (enabled(net, marking, transition)) {
                    List<Integer> next = fired(net, marking, transition);
                    if (found.add(next)) {
                        open.add(next);
                    }
                }
            }
        }
        complete = open.isEmpty();
    }

    public Set<List<Integer>> found() {
        return found;
    }

    public boolean isComplete() {
        return complete;
    }

    /** The most tokens of a place that were seen. */
    public int most(int place) {
        return found.stream().mapToInt(marking -> marking.get(place)).max().orElseThrow();
    }

    /** Whether a marking without an enabled transition was seen. */
    public boolean stops() {
        return found.stream().anyMatch(marking -> {
            for (int transition = 0; transition < net.transitionCount(); transition++) {
                if (enabled(net, marking, transition)) {
                    return false;
                }
            }
            return true;
        });
    }

    /** The firing rule, read from the arcs. */
    public static boolean enabled(PetriNet net, List<Integer> marking, int transition) {
        for (int place = 0; place < marking.size(); place++) {
            int limit = net.inhibitors().weight(transition, place);
            if (marking.get(place) < net.consumed().weight(transition, place)
                    || (limit > 0 && marking.get(place) >= limit)) {
                return false;
            }
        }
        return true;
    }

    /** Consume, empty, produce. */
    public static List<Integer> fired(PetriNet net, List<Integer> marking, int transition) {
        List<Integer> next = new ArrayList<>();
        for (int place = 0; place < marking.size(); place++) {
            int left = marking.get(place) - net.consumed().weight(transition, place);
            left = net.resets().weight(transition, place) > 0 ? 0 : left;
            next.add(left + net.produced().weight(transition, place));
        }
        return next;
    }

    static int[] array(List<Integer> marking) {
        return marking.stream().mapToInt(Integer::intValue).toArray();
    }
}
