package org.sami.petri.graph;

import org.jspecify.annotations.Nullable;
import org.sami.petri.net.PetriNet;

/**
 * Strong stubborn sets, by which a search that looks for deadlocks fires fewer transitions. A set is closed so that no transition outside it can enable a disabled
 * one of it, or disable, be disabled by, or depend in its effect on an enabled one of it; with at least one enabled transition in it, every deadlock is still
 * reached. Source: Valmari, Stubborn sets for reduced state space generation, 1990; extended to inhibitor and reset arcs by {@link TransitionRelations}. For one
 * thread.
 */
final class StubbornSets {
    /** So many of the enabled transitions are tried as the first one of a set. */
    private static final int SEEDS = 12;

    /** After so many relations the choice for a state ends, so that the search looks at its clock and its watch in time. */
    static final int MOST_VISITED = 1_000_000;

    private final PetriNet net;
    private final TransitionRelations relations;
    private final boolean[] enabled;
    private final int[] mark;
    private int stamp;
    private long visited;
    private final int[] open;
    private final int[] inSet;
    private final int[] best;

    StubbornSets(PetriNet net) {
        this.net = net;
        int transitions = net.transitionCount();
        relations = new TransitionRelations(net);
        enabled = new boolean[transitions];
        mark = new int[transitions];
        open = new int[transitions];
        inSet = new int[transitions];
        best = new int[transitions];
    }

    /**
     * Keeps the enabled transitions of a stubborn set. Where that takes too many relations it keeps those of the smallest set that was closed by then, or, with none,
     * all of them, which are a stubborn set too.
     *
     * @param list the enabled transitions; those of the set stand at its beginning afterwards
     * @param count how many there are, 1 or more
     * @return how many are in the set, 1 or more
     */
    int choose(int[] marking, int[] list, int count) {
        visited = 0;
        if (count == 1) {
            return 1;
        }
        for (int i = 0; i < count; i++) {
            enabled[list[i]] = true;
        }
        int least = Integer.MAX_VALUE;
        for (int seed = 0; seed < Math.min(SEEDS, count) && least > 1 && visited <= MOST_VISITED; seed++) {
            int size = close(list[seed], marking, least);
            if (size < least) {
                least = size;
                System.arraycopy(inSet, 0, best, 0, size);
            }
        }
        for (int i = 0; i < count; i++) {
            enabled[list[i]] = false;
        }
        if (least == Integer.MAX_VALUE) {
            return count;
        }
        System.arraycopy(best, 0, list, 0, least);
        return least;
    }

    /** How many relations between transitions the last choice visited. */
    long visited() {
        return visited;
    }

    /**
     * Closes the set that begins with a transition; returns how many of it are enabled, or {@code limit} once there are so many or too many relations were visited.
     */
    private int close(int seed, int[] marking, int limit) {
        stamp++;
        int waiting = 0;
        int found = 0;
        mark[seed] = stamp;
        open[waiting++] = seed;
        while (waiting > 0) {
            int transition = open[--waiting];
            if (enabled[transition]) {
                if (found + 1 >= limit) {
                    return limit;
                }
                inSet[found++] = transition;
            }
            int[] needed = enabled[transition] ? relations.dependentOn(transition) : enablers(transition, marking);
            visited += 1 + needed.length;
            if (visited > MOST_VISITED) {
                return limit;
            }
            for (int other : needed) {
                if (mark[other] != stamp) {
                    mark[other] = stamp;
                    open[waiting++] = other;
                }
            }
        }
        return found;
    }

    /** The transitions without which a disabled one stays disabled: those that change one place that disables it. */
    private int[] enablers(int transition, int[] marking) {
        int @Nullable [] fewest = null;
        for (int arc = net.consumed().from(transition); arc < net.consumed().to(transition); arc++) {
            if (marking[net.consumed().node(arc)] < net.consumed().weight(arc)) {
                fewest = fewer(fewest, relations.raising(net.consumed().node(arc)));
            }
        }
        for (int arc = net.inhibitors().from(transition); arc < net.inhibitors().to(transition); arc++) {
            if (marking[net.inhibitors().node(arc)] >= net.inhibitors().weight(arc)) {
                fewest = fewer(fewest, relations.lowering(net.inhibitors().node(arc)));
            }
        }
        if (fewest == null) {
            throw new IllegalStateException("transition " + net.transitionId(transition) + " is enabled");
        }
        return fewest;
    }

    private static int[] fewer(int @Nullable [] first, int[] second) {
        return first == null || second.length < first.length ? second : first;
    }
}
