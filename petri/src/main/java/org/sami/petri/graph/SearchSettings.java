package org.sami.petri.graph;

import java.util.Optional;
import java.util.function.IntPredicate;

/** What a search looks for, what it keeps and what it leaves out. Immutable; each {@code with} method returns a changed copy. */
public final class SearchSettings {
    private final SearchBudget budget;
    private final Optional<IntPredicate> edges;
    private final boolean reduced;
    private final boolean stopsAtDeadlock;
    private final Optional<MarkingTest> goal;
    private final Optional<MarkingSymmetry> symmetry;

    private SearchSettings(
            SearchBudget budget,
            Optional<IntPredicate> edges,
            boolean reduced,
            boolean stopsAtDeadlock,
            Optional<MarkingTest> goal,
            Optional<MarkingSymmetry> symmetry) {
        this.budget = budget;
        this.edges = edges;
        this.reduced = reduced;
        this.stopsAtDeadlock = stopsAtDeadlock;
        this.goal = goal;
        this.symmetry = symmetry;
    }

    /** The whole graph, without its edges. */
    public static SearchSettings within(SearchBudget budget) {
        return new SearchSettings(budget, Optional.empty(), false, false, Optional.empty(), Optional.empty());
    }

    /** Keeps the edges, at four bytes each. */
    public SearchSettings withEdges() {
        return withEdgesOf(transition -> true);
    }

    /** Keeps the edges of some transitions. */
    public SearchSettings withEdgesOf(IntPredicate transitions) {
        return new SearchSettings(budget, Optional.of(transitions), reduced, stopsAtDeadlock, goal, symmetry);
    }

    /** Ends at the first marking that fulfils a condition: no other is nearer to the initial marking. */
    public SearchSettings withGoal(MarkingTest test) {
        return new SearchSettings(budget, edges, reduced, stopsAtDeadlock, Optional.of(test), symmetry);
    }

    /** Ends at the first marking in which no transition is enabled. */
    public SearchSettings withStopAtDeadlock() {
        return new SearchSettings(budget, edges, reduced, true, goal, symmetry);
    }

    /** Fires a stubborn set of transitions in each state: every deadlock is still reached, other states are left out. */
    public SearchSettings withReduction() {
        return new SearchSettings(budget, edges, true, stopsAtDeadlock, goal, symmetry);
    }

    /** Looks at one of all states that are like each other. Goals must not tell such states apart. */
    public SearchSettings withSymmetry(MarkingSymmetry like) {
        return new SearchSettings(budget, edges, reduced, stopsAtDeadlock, goal, Optional.of(like));
    }

    public SearchBudget budget() {
        return budget;
    }

    /** Of which transitions edges are kept; empty where none are. */
    Optional<IntPredicate> edges() {
        return edges;
    }

    boolean isReduced() {
        return reduced;
    }

    boolean stopsAtDeadlock() {
        return stopsAtDeadlock;
    }

    Optional<MarkingTest> goal() {
        return goal;
    }

    Optional<MarkingSymmetry> symmetry() {
        return symmetry;
    }
}
