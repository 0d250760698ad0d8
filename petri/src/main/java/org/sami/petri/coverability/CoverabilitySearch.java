package org.sami.petri.coverability;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.LongSupplier;
import java.util.stream.IntStream;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchEnd;
import org.sami.petri.net.PetriNet;

/**
 * Builds the minimal coverability set of a net depth first. A marking that is covered by one that was found is dropped; one that is found removes those that it covers,
 * and nothing more is fired from them. Before a marking is kept it is compared with markings on the run to it, removed ones included: where it covers one and has more
 * tokens in a place, that place becomes unbounded, as the run from the one to the other can be repeated. On long runs it is compared with the last ones and with one of
 * each {@link MarkingOrigin#MILESTONE} before: on a run without end infinitely many of these would meet, so the search ends all the same, and a set that is closed under firings is
 * exact however it was found.
 *
 * <p>Why nothing is lost: each marking that was found stays covered by one that is kept, as a marking is removed only by one that covers it, and from each that is kept
 * everything is fired. Descendants of a removed marking stay until they are covered themselves; that is why no promise to explore is ever broken, which was the mistake
 * in the first algorithms that pruned whole subtrees.
 *
 * <p>Places with inhibitor or reset arcs are compared exactly ({@link MarkingOrder}). If they are bounded the search ends, and the set is exact; otherwise it runs to
 * its budget.
 *
 * <p>Source: Valmari and Hansen, "Old and new algorithms for minimal coverability sets", Fundamenta Informaticae 131(1), 2014, whose basic algorithm this is; Reynier
 * and Servais, "Minimal coverability set for Petri nets: Karp and Miller algorithm with pruning", Fundamenta Informaticae 122(1-2), 2013, for what pruning must keep;
 * Karp and Miller, "Parallel program schemata", 1969. For one thread, once.
 */
public final class CoverabilitySearch {
    private static final int CHECK_EVERY = 256;
    private static final int BYTES_A_NODE = 130;

    private final PetriNet net;
    private final SearchBudget budget;
    private final GraphWatch watch;
    private final LongSupplier nanos;
    private final MarkingOrder order;
    private final List<int[]> markings = new ArrayList<>();
    private final List<MarkingOrigin> origins = new ArrayList<>();
    private final Set<SeenMarking> seen = new HashSet<>();
    private final BitSet kept = new BitSet();
    private final MaximalMarkings maximal;
    private final Deque<Integer> open = new ArrayDeque<>();
    private SearchEnd end = SearchEnd.COMPLETE;
    private int looked;
    private long fired;

    /** A marking as a key. */
    private static final class SeenMarking {
        private final int[] tokens;

        private SeenMarking(int[] tokens) {
            this.tokens = tokens;
        }

        @Override
        public boolean equals(Object other) {
            return other instanceof SeenMarking that && Arrays.equals(tokens, that.tokens);
        }

        @Override
        public int hashCode() {
            return Arrays.hashCode(tokens);
        }
    }

    private CoverabilitySearch(PetriNet net, SearchBudget budget, GraphWatch watch, LongSupplier nanos) {
        this.net = net;
        this.budget = budget;
        this.watch = watch;
        this.nanos = nanos;
        this.order = new MarkingOrder(net);
        this.maximal = new MaximalMarkings(order, markings);
    }

    /**
     * Searches within a budget of markings, memory and time.
     *
     * @param nanos the clock, in ns
     */
    public static CoverabilitySet search(PetriNet net, SearchBudget budget, GraphWatch watch, LongSupplier nanos) {
        return new CoverabilitySearch(net, budget, watch, nanos).run();
    }

    private CoverabilitySet run() {
        long deadline = nanos.getAsLong() + budget.time().toNanos();
        int[] initial = net.initialMarking();
        try {
            if (IntStream.of(initial).anyMatch(tokens -> tokens == Omega.OMEGA)) {
                throw new ArithmeticException("more than " + (Omega.OMEGA - 1) + " tokens");
            }
            keep(initial, MarkingOrigin.FIRST);
            while (end == SearchEnd.COMPLETE && !open.isEmpty()) {
                int node = open.pop();
                if (kept.get(node)) {
                    fireAll(node, deadline);
                }
                looked++;
            }
        } catch (ArithmeticException e) {
            end = SearchEnd.TOKENS;
        }
        watch.looked(looked, open.size());
        return new CoverabilitySet(net, order, markings, origins, kept, end);
    }

    /** Whether the search has to end; asked at each firing. */
    private SearchEnd checked(long deadline) {
        if (markings.size() > budget.states()) {
            return SearchEnd.STATES;
        }
        if ((long) markings.size() * (BYTES_A_NODE + 4L * net.placeCount()) > budget.bytes()) {
            return SearchEnd.MEMORY;
        }
        if (++fired % CHECK_EVERY == 0) {
            watch.looked(looked, open.size());
            if (watch.isCancelled()) {
                return SearchEnd.CANCELLED;
            }
            if (nanos.getAsLong() - deadline >= 0) {
                return SearchEnd.TIME;
            }
        }
        return SearchEnd.COMPLETE;
    }

    private void fireAll(int node, long deadline) {
        int[] marking = markings.get(node);
        for (int transition = 0; transition < net.transitionCount() && kept.get(node); transition++) {
            if (Omega.isEnabled(net, transition, marking)) {
                int[] next = Omega.fire(net, transition, marking);
                if (!seen.contains(new SeenMarking(next)) && maximal.covering(next) < 0) {
                    int from = accelerate(next, node);
                    keep(next, origins.get(node).next(node, transition, from));
                }
                end = checked(deadline);
                if (end != SearchEnd.COMPLETE) {
                    return;
                }
            }
        }
    }

    /** The marking on the run to one with which to compare next: its parent, or, once a milestone is reached, the milestone before. */
    private int earlier(int node) {
        MarkingOrigin origin = origins.get(node);
        return origin.isMilestone() ? origin.milestone() : origin.parent();
    }

    /** Makes places of a marking unbounded that grow on the run to it; returns the marking from which the run was first seen to repeat, -1 where none was. */
    private int accelerate(int[] marking, int parent) {
        int first = -1;
        boolean grown = true;
        while (grown) {
            grown = false;
            for (int node = parent; node >= 0; node = earlier(node)) {
                int[] before = markings.get(node);
                if (order.covers(marking, before) && grow(marking, before)) {
                    grown = true;
                    first = first < 0 ? node : first;
                }
            }
        }
        return first;
    }

    private static boolean grow(int[] marking, int[] before) {
        boolean grown = false;
        for (int place = 0; place < marking.length; place++) {
            if (marking[place] > before[place] && marking[place] != Omega.OMEGA) {
                marking[place] = Omega.OMEGA;
                grown = true;
            }
        }
        return grown;
    }

    private void keep(int[] marking, MarkingOrigin origin) {
        int number = markings.size();
        markings.add(marking);
        origins.add(origin);
        seen.add(new SeenMarking(marking));
        kept.set(number);
        maximal.add(number, kept::clear);
        open.push(number);
    }
}
