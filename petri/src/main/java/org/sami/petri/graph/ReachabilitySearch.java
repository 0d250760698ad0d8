package org.sami.petri.graph;

import java.util.BitSet;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.IntPredicate;
import java.util.function.LongSupplier;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.sami.petri.net.PetriNet;

/**
 * Builds the reachability graph of a net breadth first, so that the run to each state that it keeps is a shortest one. Of a state it keeps the packed marking, the
 * state from which it was found and a slot of the hash table, nothing else (thesis, section 4.2.1). For one thread, once.
 */
public final class ReachabilitySearch {
    /** After so much work the clock, the memory and the watch are looked at; a firing is one. */
    private static final int CHECK_EVERY = 20_000;

    /** A firing whose marking is also brought into its normal form is so many. */
    private static final int NORMALIZED = 9;

    /** So small a part of the time is added for states that were found and not followed. */
    private static final int PART_FOR_WAITING = 10;

    /** As many places of a marking that is loaded are one. */
    private static final int PLACES = 16;

    /** As many relations of transitions that are visited are one. */
    private static final int RELATIONS = 16;

    private final PetriNet net;
    private final SearchSettings settings;
    private final GraphWatch watch;
    private final LongSupplier nanos;
    private final EnabledTransitions enabledTransitions;
    private final @Nullable StubbornSets stubborn;
    private final @Nullable MarkingTest goal;
    private final @Nullable MarkingSymmetry symmetry;
    private final StateSpace space;
    private final IntChunks parents = new IntChunks();
    private final @Nullable StateEdges edges;
    private final SearchMemory memory;
    private final IntPredicate keepsEdge;
    private final IntChunks deadlocks = new IntChunks();
    private final BitSet fired;
    private final int[] mostTokens;
    private final int[] marking;
    private final int[] after;
    private final int[] enabled;
    private long[] state;
    private long[] next;
    private long edgeCount;
    private int looked;
    private int checkAt;
    private long work = CHECK_EVERY; // since the last look at the clock, the memory and the watch
    private @Nullable SearchEnd end;
    private OptionalInt found = OptionalInt.empty();

    private ReachabilitySearch(PetriNet net, SearchSettings settings, GraphWatch watch, LongSupplier nanos) {
        this.net = net;
        this.settings = settings;
        this.watch = watch;
        this.nanos = nanos;
        enabledTransitions = new EnabledTransitions(net);
        stubborn = settings.isReduced() ? new StubbornSets(net) : null;
        goal = settings.goal().orElse(null);
        symmetry = settings.symmetry().orElse(null);
        space = new StateSpace(net);
        edges = settings.edges().isPresent() ? new StateEdges() : null;
        memory = new SearchMemory(
                space, parents, deadlocks, edges, settings.budget().bytes());
        keepsEdge = settings.edges().orElse(transition -> false);
        fired = new BitSet(net.transitionCount());
        mostTokens = new int[net.placeCount()];
        marking = new int[net.placeCount()];
        after = new int[net.placeCount()];
        enabled = new int[net.transitionCount()];
        state = new long[space.words()];
        next = new long[space.words()];
    }

    /** Searches a net without being watched. */
    public static ReachabilityGraph explore(PetriNet net, SearchSettings settings) {
        return explore(net, settings, GraphWatch.NONE, System::nanoTime);
    }

    /**
     * Searches a net.
     *
     * @param nanos a clock that never goes back, for the budget of time and the time that the search took
     */
    public static ReachabilityGraph explore(
            PetriNet net, SearchSettings settings, GraphWatch watch, LongSupplier nanos) {
        return new ReachabilitySearch(net, settings, watch, nanos).run();
    }

    private ReachabilityGraph run() {
        long start = nanos.getAsLong();
        long most = settings.budget().time().toNanos();
        int[] initial = net.initialMarking();
        if (symmetry != null) {
            symmetry.normalize(initial);
        }
        space.pack(initial, next);
        space.table().add(next);
        parents.add(-1);
        while (end == null && looked < space.table().count()) {
            if (work >= CHECK_EVERY) {
                work = 0;
                check(nanos.getAsLong() - start >= most);
            }
            if (end == null) {
                look(looked);
                looked++;
            }
        }
        if (end != null && end.isBounded() && end != SearchEnd.CANCELLED) {
            lookAtWaiting(start + most + most / PART_FOR_WAITING);
        }
        if (symmetry != null) {
            symmetry.spread(fired, mostTokens);
        }
        return new ReachabilityGraph(
                net,
                end == null ? SearchEnd.COMPLETE : end,
                settings,
                space,
                parents,
                Optional.ofNullable(edges),
                new ReachabilityGraph.Facts(
                        looked,
                        edgeCount,
                        deadlocks,
                        fired,
                        IntStream.of(mostTokens).boxed().toList(),
                        found,
                        nanos.getAsLong() - start));
    }

    private void check(boolean isLate) {
        watch.looked(looked, space.table().count() - looked);
        if (watch.isCancelled()) {
            end = SearchEnd.CANCELLED;
        } else if (isLate) {
            end = SearchEnd.TIME;
        } else if (memory.room() < 0) {
            end = SearchEnd.MEMORY;
        }
    }

    /** Looks at a state and adds those that follow it. */
    private void look(int number) {
        space.load(number, state, marking);
        if (note(number)) {
            return;
        }
        int count = enabledTransitions.find(marking, enabled);
        if (count == 0) {
            noteDeadlock(number);
        } else if (stubborn != null) {
            count = stubborn.choose(marking, enabled, count);
            work += stubborn.visited() / RELATIONS;
        }
        if (symmetry != null) {
            count = symmetry.withoutAlike(marking, enabled, count);
        }
        work += 1 + marking.length / PLACES + (long) count * (symmetry == null ? 1 : NORMALIZED);
        if (!memory.beginEdges(count)) {
            end = SearchEnd.MEMORY;
            return;
        }
        for (int i = 0; i < count; i++) {
            int target = follow(enabled[i], number);
            if (target < 0) {
                return;
            }
            fired.set(enabled[i]);
            edgeCount++;
            if (edges != null && keepsEdge.test(enabled[i])) {
                edges.add(target);
            }
        }
    }

    /** Enters a marking into the bounds of places; whether it is the goal. */
    private boolean note(int number) {
        for (int place = 0; place < marking.length; place++) {
            if (marking[place] > mostTokens[place]) {
                mostTokens[place] = marking[place];
            }
        }
        if (goal != null && goal.test(marking)) {
            foundAt(number);
            return true;
        }
        return false;
    }

    private void foundAt(int number) {
        found = OptionalInt.of(number);
        end = SearchEnd.FOUND;
    }

    /**
     * What is known of states that were found and not followed any more counts for bounds, goals and deadlocks. Ends early where the watch stops the search.
     *
     * @param until when to stop, in ns, where there are too many of them
     */
    private void lookAtWaiting(long until) {
        for (int number = looked; number < space.table().count() && found.isEmpty(); number++) {
            work += 1 + net.transitionCount() / PLACES;
            if (work >= CHECK_EVERY) {
                work = 0;
                if (watch.isCancelled() || nanos.getAsLong() - until >= 0) {
                    return;
                }
            }
            space.load(number, state, marking);
            if (!note(number) && enabledTransitions.find(marking, enabled) == 0) {
                noteDeadlock(number);
            }
        }
    }

    private void noteDeadlock(int number) {
        deadlocks.add(number);
        if (settings.stopsAtDeadlock()) {
            foundAt(number);
        }
    }

    /** The state after a firing; -1 where the search ends. */
    private int follow(int transition, int from) {
        int place = space.firing().overflow(transition, marking);
        while (place != PackedFiring.FITS) {
            if (!widen(place, space.firing().tokensAfter(transition, place, marking))) {
                return -1;
            }
            place = space.firing().overflow(transition, marking);
        }
        if (symmetry == null) {
            space.firing().fire(transition, state, marking, next);
        } else if (!fireAndNormalize(transition, symmetry)) {
            return -1;
        }
        StateTable table = space.table();
        if (table.count() >= checkAt && !hasRoom(table)) {
            return table.find(next);
        }
        int known = table.count();
        int target = table.add(next);
        if (target == known) {
            parents.add(from);
        }
        return target;
    }

    private boolean fireAndNormalize(int transition, MarkingSymmetry like) {
        PackedFiring.fire(net, transition, marking, after);
        like.normalizeAfter(transition, after);
        while (!space.pack(after, next)) {
            int place = space.overflow(after);
            if (!widen(place, after[place])) {
                return false;
            }
        }
        return true;
    }

    /** Whether there may be a new state; where not, the search ends with the next one that would be new. */
    private boolean hasRoom(StateTable table) {
        SearchEnd reason = null;
        if (table.count() >= settings.budget().states() || !table.canGrow()) {
            reason = SearchEnd.STATES;
        } else if (!memory.makeRoom()) {
            reason = SearchEnd.MEMORY;
        }
        if (reason == null) {
            checkAt = Math.min(memory.nextGrowth(), settings.budget().states());
            return true;
        }
        if (table.find(next) < 0) {
            end = reason;
        }
        return false;
    }

    private boolean widen(int place, long tokens) {
        if (tokens > Integer.MAX_VALUE) {
            end = SearchEnd.TOKENS;
            return false;
        }
        if (!space.widen(place, (int) tokens, memory.room())) {
            end = SearchEnd.MEMORY;
            return false;
        }
        state = new long[space.words()];
        next = new long[space.words()];
        space.pack(marking, state);
        checkAt = 0;
        return true;
    }
}
