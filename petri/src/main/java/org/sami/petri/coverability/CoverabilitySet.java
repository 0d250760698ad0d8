package org.sami.petri.coverability;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.sami.petri.graph.SearchEnd;
import org.sami.petri.net.FiringRule;
import org.sami.petri.net.PetriNet;

/**
 * The minimal coverability set of a net: the largest markings, with {@link Omega#OMEGA} for any number of tokens, that stand for all reachable ones. Each reachable
 * marking is covered by one of them, and each of them is the limit of reachable ones. Places with inhibitor or reset arcs are compared exactly, so two markings that
 * differ there are both in the set. Where the search did not end the markings are limits all the same: what they show to be unbounded or coverable is so, and what they
 * do not show is open.
 */
public final class CoverabilitySet {
    private final PetriNet net;
    private final MarkingOrder order;
    private final List<int[]> found;
    private final List<MarkingOrigin> origins;
    private final int[] numbers;
    private final List<int[]> markings = new ArrayList<>();
    private final SearchEnd end;

    CoverabilitySet(
            PetriNet net,
            MarkingOrder order,
            List<int[]> found,
            List<MarkingOrigin> origins,
            BitSet kept,
            SearchEnd end) {
        this.net = net;
        this.order = order;
        this.found = found;
        this.origins = origins;
        this.numbers = kept.stream().toArray();
        this.end = end;
        for (int number : numbers) {
            markings.add(found.get(number));
        }
    }

    /** Why the search ended. */
    public SearchEnd end() {
        return end;
    }

    /** Whether the set is exact. */
    public boolean isComplete() {
        return end == SearchEnd.COMPLETE;
    }

    /** How many markings are in the set. */
    public int size() {
        return markings.size();
    }

    /** How many markings were found and kept at some time. */
    public int searched() {
        return found.size();
    }

    /** The tokens by place of a marking of the set: a new array at each call. */
    public int[] marking(int number) {
        return markings.get(number).clone();
    }

    /** The places with inhibitor or reset arcs, in which numbers of tokens are exact: only if they are bounded does a search end. */
    public int[] exactPlaces() {
        return order.exactPlaces();
    }

    /** Whether a place can have any number of tokens. False is a proof only where the set is complete. */
    public boolean isUnbounded(int place) {
        return markings.stream().anyMatch(marking -> marking[place] == Omega.OMEGA);
    }

    /** The most tokens that a place was seen to have; empty where it is unbounded. They are the most that it can have where the set is complete. */
    public OptionalInt mostTokens(int place) {
        int most = markings.stream().mapToInt(marking -> marking[place]).max().orElse(0);
        return most == Omega.OMEGA ? OptionalInt.empty() : OptionalInt.of(most);
    }

    /** Whether a transition can fire at some time. False is a proof only where the set is complete. */
    public boolean canFire(int transition) {
        return markings.stream().anyMatch(marking -> Omega.isEnabled(net, transition, marking));
    }

    /** The coverability graph on this set. */
    public CoverabilityGraph graph() {
        return CoverabilityGraph.of(net, order, markings);
    }

    /**
     * A run that makes a place grow without end: firings that lead to a marking, and firings that lead from there to a larger one with more tokens in the place, and so
     * on again. Replayed by the firing rule. Empty where the place is not unbounded, and where it grows only after others have been made large.
     */
    public Optional<Pump> pump(int place) {
        for (int node = 0; node < found.size(); node++) {
            int from = origins.get(node).repeatedFrom();
            if (from >= 0 && found.get(node)[place] == Omega.OMEGA && found.get(from)[place] != Omega.OMEGA) {
                Pump pump = new Pump(run(0, from), run(from, node));
                if (pump.grows(net, place)) {
                    return Optional.of(pump);
                }
            }
        }
        return Optional.empty();
    }

    private List<Integer> run(int from, int to) {
        Deque<Integer> run = new ArrayDeque<>();
        for (int node = to; node != from; node = origins.get(node).parent()) {
            run.push(origins.get(node).transition());
        }
        return List.copyOf(run);
    }

    /**
     * A run that can be repeated for ever.
     *
     * @param lead transitions from the initial marking to where the repetition begins
     * @param repeated transitions that are fired again and again
     */
    public record Pump(List<Integer> lead, List<Integer> repeated) {
        public Pump {
            lead = List.copyOf(lead);
            repeated = List.copyOf(repeated);
        }

        /** Whether the run can be fired, and its repetition covers where it began and adds to a place. */
        boolean grows(PetriNet net, int place) {
            Optional<int[]> before = fired(net, net.initialMarking(), lead);
            Optional<int[]> after = before.flatMap(marking -> fired(net, marking, repeated));
            return after.isPresent()
                    && after.get()[place] > before.get()[place]
                    && new MarkingOrder(net).covers(after.get(), before.get());
        }

        private static Optional<int[]> fired(PetriNet net, int[] from, List<Integer> transitions) {
            int[] marking = from;
            for (int transition : transitions) {
                if (!FiringRule.isEnabled(net, transition, marking)) {
                    return Optional.empty();
                }
                try {
                    marking = FiringRule.fire(net, transition, marking);
                } catch (ArithmeticException tooManyTokens) {
                    return Optional.empty();
                }
            }
            return Optional.of(marking);
        }
    }
}
