package org.sami.petri.graph;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.sami.petri.net.FiringRule;
import org.sami.petri.net.PetriNet;

/**
 * What a {@link ReachabilitySearch} found: states, numbered from 0, the initial one, in the order of their distance from it. Where the search ended early
 * ({@link SearchEnd#isBounded}), what is said of all states holds for those that were found only. For one thread at a time.
 */
public final class ReachabilityGraph {
    private final PetriNet net;
    private final SearchEnd end;
    private final SearchSettings settings;
    private final StateSpace space;
    private final IntChunks parents;
    private final Optional<StateEdges> edges;
    private final Facts facts;
    private final long[] packed;
    private final int[] unpacked;

    /** Numbers and marks of a search. */
    record Facts(
            int looked,
            long edges,
            IntChunks deadlocks,
            BitSet fired,
            List<Integer> mostTokens,
            OptionalInt found,
            long nanos) {}

    ReachabilityGraph(
            PetriNet net,
            SearchEnd end,
            SearchSettings settings,
            StateSpace space,
            IntChunks parents,
            Optional<StateEdges> edges,
            Facts facts) {
        this.net = net;
        this.end = end;
        this.settings = settings;
        this.space = space;
        this.parents = parents;
        this.edges = edges;
        this.facts = facts;
        packed = new long[space.words()];
        unpacked = new int[net.placeCount()];
    }

    public PetriNet net() {
        return net;
    }

    /** Why the search ended. */
    public SearchEnd end() {
        return end;
    }

    /** Whether every state that can be reached is here. Of a reduced search: whether every deadlock is. */
    public boolean isComplete() {
        return end == SearchEnd.COMPLETE;
    }

    /** How many states were found. */
    public int states() {
        return space.table().count();
    }

    /** How many of them were looked at: all, where the search is complete. */
    public int looked() {
        return facts.looked();
    }

    /** How many firings lead from the states that were looked at. */
    public long edges() {
        return facts.edges();
    }

    /** How long the search took, in nanoseconds. */
    public long nanos() {
        return facts.nanos();
    }

    /** The memory of states, hash table, shortest runs and edges, in bytes. */
    public long bytes() {
        return space.bytes() + parents.bytes() + edges.map(StateEdges::bytes).orElse(0L);
    }

    /** The state at which the search ended because it was searched for; empty where there was none. */
    public OptionalInt found() {
        return facts.found();
    }

    /** The states in which no transition is enabled, the nearest first. */
    public List<Integer> deadlocks() {
        return IntStream.range(0, (int) facts.deadlocks().size())
                .mapToObj(i -> facts.deadlocks().get(i))
                .toList();
    }

    /** The transitions that fired nowhere. A proof that they never can only where the search is complete and not reduced. */
    public List<Integer> deadTransitions() {
        return IntStream.range(0, net.transitionCount())
                .filter(t -> !facts.fired().get(t))
                .boxed()
                .toList();
    }

    /** The most tokens that a place has in any of the states. */
    public int mostTokens(int place) {
        return facts.mostTokens().get(place);
    }

    /** The tokens of each place in a state: a new array. */
    public int[] marking(int state) {
        int[] marking = new int[net.placeCount()];
        space.load(state, new long[space.words()], marking);
        return marking;
    }

    /** Whether a state fulfils a condition. */
    boolean fulfils(int state, MarkingTest condition) {
        space.load(state, packed, unpacked);
        return condition.test(unpacked);
    }

    /** The state nearest to the initial one that fulfils a condition; empty where none of those that were found does. */
    public OptionalInt first(MarkingTest condition) {
        for (int state = 0; state < states(); state++) {
            if (fulfils(state, condition)) {
                return OptionalInt.of(state);
            }
        }
        return OptionalInt.empty();
    }

    /** The state of a marking; empty where it was not found. */
    public OptionalInt stateOf(int[] marking) {
        int[] normal = marking.clone();
        settings.symmetry().ifPresent(like -> like.normalize(normal));
        int state = space.find(normal);
        return state < 0 ? OptionalInt.empty() : OptionalInt.of(state);
    }

    /** The edges by state; empty where they were not kept. */
    Optional<StateEdges> keptEdges() {
        return edges;
    }

    /**
     * The states that follow a state, one for each firing.
     *
     * @throws IllegalStateException if the edges were not kept, or the state was not looked at
     */
    public int[] successors(int state) {
        StateEdges kept = edges.orElseThrow(() -> new IllegalStateException("the search kept no edges"));
        if (state >= kept.states()) {
            throw new IllegalStateException("state " + state + " was not looked at");
        }
        int[] successors = new int[(int) (kept.to(state) - kept.from(state))];
        for (int i = 0; i < successors.length; i++) {
            successors[i] = kept.target(kept.from(state) + i);
        }
        return successors;
    }

    /**
     * The transitions that are enabled in a state, each with the state to which it leads; needs no kept edges. Where states that are like each other are one, each
     * transition of the state that stands for them. A firing to a state that was not found, as the search ended early, is left out.
     */
    public List<StateFiring> firings(int state) {
        int[] marking = marking(state);
        List<StateFiring> firings = new ArrayList<>();
        for (int transition = 0; transition < net.transitionCount(); transition++) {
            int fired = transition;
            fire(transition, marking)
                    .map(this::stateOf)
                    .ifPresent(target -> target.ifPresent(to -> firings.add(new StateFiring(fired, to))));
        }
        return firings;
    }

    /**
     * A firing from a state.
     *
     * @param target number of the state after it
     */
    public record StateFiring(int transition, int target) {}

    /**
     * A run to a state: a shortest one, unless the search was reduced. Where states that are like each other are one, it leads to a state that is like the one
     * asked for.
     */
    public FiringSequence runTo(int state) {
        List<Integer> way = new ArrayList<>();
        for (int next = state; next > 0; next = parents.get(next)) {
            way.add(next);
        }
        Collections.reverse(way);
        List<Integer> transitions = new ArrayList<>();
        int[] initial = net.initialMarking();
        int[] real = settings.symmetry() // for each transition at the state that was kept, the one of the run
                .map(like -> like.normalizeAndTrace(initial))
                .orElseGet(() -> IntStream.range(0, net.transitionCount()).toArray());
        int at = 0;
        for (int target : way) {
            Step step = step(at, target);
            transitions.add(real[step.transition()]);
            int[] outer = real;
            real = settings.symmetry().isEmpty()
                    ? real
                    : step.before().stream().mapToInt(same -> outer[same]).toArray();
            at = target;
        }
        return new FiringSequence(transitions);
    }

    /**
     * A firing between two states.
     *
     * @param before for each transition after it the one that it was before; empty where no states are like each other
     */
    private record Step(int transition, List<Integer> before) {}

    private Step step(int from, int target) {
        int[] marking = marking(from);
        for (int transition = 0; transition < net.transitionCount(); transition++) {
            Optional<int[]> next = fire(transition, marking);
            if (next.isPresent()) {
                int fired = transition;
                int[] after = next.get();
                List<Integer> before = settings.symmetry()
                        .map(like -> IntStream.of(like.normalizeAfterAndTrace(fired, after))
                                .boxed()
                                .toList())
                        .orElse(List.of());
                if (space.find(after) == target) {
                    return new Step(transition, before);
                }
            }
        }
        throw new IllegalStateException("no transition leads from state " + from + " to state " + target);
    }

    /** The marking after a firing; empty where it is not enabled, or would lead to more tokens than can be counted. */
    private Optional<int[]> fire(int transition, int[] marking) {
        try {
            return FiringRule.isEnabled(net, transition, marking)
                    ? Optional.of(FiringRule.fire(net, transition, marking))
                    : Optional.empty();
        } catch (ArithmeticException tooManyTokens) {
            return Optional.empty();
        }
    }
}
