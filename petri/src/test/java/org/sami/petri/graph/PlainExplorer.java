package org.sami.petri.graph;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/** A small explorer that is obviously right and shares no code with the real one: markings as lists in a hash map, the firing rule written out once more. */
public final class PlainExplorer {
    /** How many firings lead to each marking at least. */
    public final Map<List<Integer>, Integer> distances = new HashMap<>();
    /** The markings after each firing; of those markings that were followed. */
    public final Map<List<Integer>, List<List<Integer>>> successors = new HashMap<>();
    /** The most tokens of each place. */
    public final int[] most;

    /** Which transitions fired. */
    public final boolean[] fired;

    /** Explores until there are more markings than that. */
    public PlainExplorer(PetriNet net, int mostStates) {
        most = new int[net.placeCount()];
        fired = new boolean[net.transitionCount()];
        Deque<List<Integer>> open = new ArrayDeque<>();
        List<Integer> initial = list(net.initialMarking());
        distances.put(initial, 0);
        open.add(initial);
        while (!open.isEmpty() && distances.size() <= mostStates) {
            List<Integer> marking = open.poll();
            List<List<Integer>> next = new ArrayList<>();
            successors.put(marking, next);
            for (int p = 0; p < most.length; p++) {
                most[p] = Math.max(most[p], marking.get(p));
            }
            for (int t = 0; t < net.transitionCount(); t++) {
                int[] after = fire(net, t, marking);
                if (after.length == 0) {
                    continue;
                }
                fired[t] = true;
                next.add(list(after));
                if (distances.putIfAbsent(list(after), distances.get(marking) + 1) == null) {
                    open.add(list(after));
                }
            }
        }
    }

    /** Whether all markings were followed. */
    public boolean isComplete() {
        return successors.size() == distances.size();
    }

    long edges() {
        return successors.values().stream().mapToLong(List::size).sum();
    }

    long deadlocks() {
        return successors.values().stream().filter(List::isEmpty).count();
    }

    /** The markings from which one with a property can be reached: looked for again and again until there are no more. */
    public Set<List<Integer>> reaching(Predicate<List<Integer>> property) {
        Set<List<Integer>> found = new HashSet<>();
        distances.keySet().stream().filter(property).forEach(found::add);
        boolean isMore = true;
        while (isMore) {
            isMore = false;
            for (Map.Entry<List<Integer>, List<List<Integer>>> marking : successors.entrySet()) {
                if (!found.contains(marking.getKey())
                        && marking.getValue().stream().anyMatch(found::contains)) {
                    isMore = found.add(marking.getKey());
                }
            }
        }
        return found;
    }

    /** A marking as a list. */
    public static List<Integer> list(int[] marking) {
        return Arrays.stream(marking).boxed().toList();
    }

    /** The marking after a firing; of length 0 where the transition is not enabled. Nets without places are not explored. */
    private static int[] fire(PetriNet net, int t, List<Integer> marking) {
        int[] after = marking.stream().mapToInt(Integer::intValue).toArray();
        for (int p = 0; p < after.length; p++) {
            int least = weight(net.consumed(), t, p);
            int inhibits = weight(net.inhibitors(), t, p);
            if (after[p] < least || (inhibits > 0 && after[p] >= inhibits)) {
                return new int[0];
            }
            int rest = weight(net.resets(), t, p) > 0 ? 0 : after[p] - least;
            after[p] = rest + weight(net.produced(), t, p);
        }
        return after;
    }

    private static int weight(ArcTable arcs, int t, int p) {
        for (int arc = arcs.from(t); arc < arcs.to(t); arc++) {
            if (arcs.node(arc) == p) {
                return arcs.weight(arc);
            }
        }
        return 0;
    }
}
