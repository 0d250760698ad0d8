package org.sami.petri.query;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.LongSupplier;
import org.sami.petri.graph.FiringSequence;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.HomeStates;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.MarkingCondition.All;
import org.sami.petri.query.MarkingCondition.Not;
import org.sami.petri.query.MarkingCondition.NothingEnabled;
import org.sami.petri.query.QueryAnswer.NetVerdict;

/**
 * Answers queries by searches. A query about deadlocks is answered by a reduced search; where that finds one, a search without reduction looks for the nearest,
 * within the same budget. For one thread.
 */
public final class QueryRunner {
    /** A graph is kept where it takes less than this part of the memory. */
    private static final int PART_OF_MEMORY = 4;

    private final PetriNet net;
    private final SearchBudget budget;
    private final QueryMeans means;
    private final GraphWatch watch;
    private final LongSupplier nanos;

    /** Whole graphs with their edges, by whether states that are alike are one. */
    private final Map<Boolean, ReachabilityGraph> known = new HashMap<>();

    /**
     * A runner for a net.
     *
     * @param budget of each search
     * @param nanos a clock that never goes back
     */
    public QueryRunner(PetriNet net, SearchBudget budget, QueryMeans means, GraphWatch watch, LongSupplier nanos) {
        this.net = net;
        this.budget = budget;
        this.means = means;
        this.watch = watch;
        this.nanos = nanos;
    }

    /** The whole graph with its edges, by symmetry where the net has any, as far as the budget goes. Later queries are answered from it. */
    public ReachabilityGraph whole() {
        ReachabilityGraph graph = known.get(isSymmetric(true));
        return graph != null ? graph : search(settings(true).withEdges(), isSymmetric(true));
    }

    /**
     * Answers later queries from a graph of the net, by symmetry where the net has any.
     *
     * @param graph with its edges; complete, or as far as the budget went
     */
    public void know(ReachabilityGraph graph) {
        known.put(isSymmetric(true), graph);
    }

    /** Answers a query about the net. */
    public QueryAnswer answer(NetQuery query) {
        if (query instanceof NetQuery.Reachable reachable) {
            return first(reachable.condition(), true, "such a marking");
        } else if (query instanceof NetQuery.Invariant invariant) {
            return first(new Not(invariant.condition()), false, "a marking that breaks it");
        } else if (query instanceof NetQuery.Deadlock deadlock) {
            return deadlock(deadlock);
        } else if (query instanceof NetQuery.Home home) {
            return home(home.condition());
        } else if (query instanceof NetQuery.Bound bound) {
            return bound(bound.place());
        } else if (query instanceof NetQuery.BoundOfSum bound) {
            return bound(bound);
        }
        throw new IllegalArgumentException("a query of an unknown kind: " + query);
    }

    private boolean isKept(MarkingCondition condition) {
        return means.symmetry()
                .filter(symmetry -> ConditionSymmetry.isKept(condition, symmetry))
                .isPresent();
    }

    /** Whether a search takes states that are alike as one: where the net has such, and the question allows it. */
    private boolean isSymmetric(boolean isKept) {
        return isKept
                && means.symmetry().filter(symmetry -> !symmetry.isEmpty()).isPresent();
    }

    private SearchSettings settings(boolean isKept) {
        SearchSettings plain = SearchSettings.within(budget);
        return isSymmetric(isKept) ? plain.withSymmetry(means.symmetry().orElseThrow()) : plain;
    }

    private ReachabilityGraph search(SearchSettings settings) {
        return ReachabilitySearch.explore(net, settings, watch, nanos);
    }

    /** A whole graph with its edges, which is kept where it leaves most of the memory to later searches. */
    private ReachabilityGraph search(SearchSettings settings, boolean isSymmetric) {
        ReachabilityGraph graph = search(settings);
        if (graph.isComplete() && graph.bytes() < budget.bytes() / PART_OF_MEMORY) {
            known.put(isSymmetric, graph);
        }
        return graph;
    }

    /** The answer of a search for a marking; from a graph that is known already, if there is one. */
    private QueryAnswer first(MarkingCondition goal, boolean whenFound, String what) {
        boolean isKept = isKept(goal);
        ReachabilityGraph whole = known.get(isSymmetric(isKept));
        return whole == null
                ? found(search(settings(isKept).withGoal(goal)), whenFound, what)
                : found(whole, whole.first(goal), whenFound, what);
    }

    /** The answer of a search that ends where it finds something. */
    private static QueryAnswer found(ReachabilityGraph graph, boolean whenFound, String what) {
        return found(graph, graph.found(), whenFound, what);
    }

    private static QueryAnswer found(ReachabilityGraph graph, OptionalInt state, boolean whenFound, String what) {
        if (state.isPresent()) {
            FiringSequence run = graph.runTo(state.getAsInt());
            return new QueryAnswer(
                    whenFound ? NetVerdict.YES : NetVerdict.NO,
                    what + " is reached by " + run.transitions().size() + " firings",
                    Optional.of(run),
                    graph);
        }
        return graph.isComplete()
                ? new QueryAnswer(
                        whenFound ? NetVerdict.NO : NetVerdict.YES, what + " is never reached", Optional.empty(), graph)
                : unknown(graph, what + " was not found");
    }

    private static QueryAnswer unknown(ReachabilityGraph graph, String words) {
        return new QueryAnswer(
                NetVerdict.UNKNOWN,
                words + " among " + graph.states() + " states: bounded search only, as "
                        + graph.end().words(),
                Optional.empty(),
                graph);
    }

    private QueryAnswer deadlock(NetQuery.Deadlock query) {
        MarkingCondition goal = new All(List.of(new NothingEnabled(net), new Not(query.end())));
        String what = "a deadlock";
        boolean isKept = isKept(goal);
        ReachabilityGraph whole = known.get(isSymmetric(isKept));
        if (whole != null) {
            OptionalInt nearest = whole.deadlocks().stream()
                    .mapToInt(Integer::intValue)
                    .filter(state -> goal.test(whole.marking(state)))
                    .min();
            return found(whole, nearest, true, what);
        }
        if (!means.reduces()) {
            return found(search(settings(isKept).withGoal(goal)), true, what);
        }
        QueryAnswer reduced = found(search(settings(isKept).withGoal(goal).withReduction()), true, what);
        if (reduced.verdict() != NetVerdict.YES) {
            return reduced;
        }
        QueryAnswer nearest = found(search(settings(isKept).withGoal(goal)), true, what);
        return nearest.verdict() == NetVerdict.YES
                ? nearest
                : new QueryAnswer(
                        NetVerdict.YES,
                        reduced.words() + "; there may be a nearer one, which the budget did not find",
                        reduced.witness(),
                        reduced.graph());
    }

    private QueryAnswer home(MarkingCondition condition) {
        boolean isSymmetric = isSymmetric(isKept(condition));
        ReachabilityGraph graph = known.get(isSymmetric);
        if (graph == null) {
            graph = search(settings(isSymmetric).withEdges(), isSymmetric);
        }
        if (!graph.isComplete()) {
            return unknown(graph, "not every run was followed to its end");
        }
        if (!HomeStates.fits(graph, budget.bytes())) {
            return new QueryAnswer(
                    NetVerdict.UNKNOWN,
                    "the graph has " + graph.states()
                            + " states, and the way back through it needs more memory than the budget",
                    Optional.empty(),
                    graph);
        }
        HomeStates states = HomeStates.of(graph, condition);
        if (states.firstWithout().isEmpty()) {
            return new QueryAnswer(
                    NetVerdict.YES,
                    "from each of the " + graph.states() + " states such a marking can be reached",
                    Optional.empty(),
                    graph);
        }
        FiringSequence run = graph.runTo(states.firstWithout().getAsInt());
        return new QueryAnswer(
                NetVerdict.NO,
                "from " + (graph.states() - states.count()) + " of " + graph.states()
                        + " states no such marking can be reached any more; the nearest is reached by "
                        + run.transitions().size() + " firings",
                Optional.of(run),
                graph);
    }

    private QueryAnswer bound(NetQuery.BoundOfSum bound) {
        boolean isKept = isKept(new LinearComparison(bound.terms(), LinearComparison.Relation.AT_LEAST, 0));
        ReachabilityGraph whole = known.get(isSymmetric(isKept));
        ReachabilityGraph graph = whole == null ? search(settings(isKept)) : whole;
        int highest = 0;
        long most = Long.MIN_VALUE;
        for (int state = 0; state < graph.states(); state++) {
            long sum = bound.of(graph.marking(state));
            if (sum > most) {
                most = sum;
                highest = state;
            }
        }
        Optional<FiringSequence> run = Optional.of(graph.runTo(highest));
        return graph.isComplete()
                ? new QueryAnswer(NetVerdict.YES, bound.text() + " is at most " + most, run, graph)
                : new QueryAnswer(
                        NetVerdict.UNKNOWN,
                        bound.text() + " is up to " + most + " among " + graph.states()
                                + " states: bounded search only, as "
                                + graph.end().words(),
                        run,
                        graph);
    }

    private QueryAnswer bound(int place) {
        MarkingCondition tellsPlaceApart = new LinearComparison(
                List.of(new LinearComparison.Term(place, 1)), LinearComparison.Relation.AT_LEAST, 0);
        boolean isKept = isKept(tellsPlaceApart);
        ReachabilityGraph whole = known.get(isSymmetric(isKept));
        ReachabilityGraph graph = whole == null ? search(settings(isKept)) : whole;
        int most = graph.mostTokens(place);
        Optional<FiringSequence> run = graph.first(marking -> marking[place] == most).stream()
                .mapToObj(graph::runTo)
                .findFirst();
        String words = "place " + net.placeId(place) + " has ";
        return graph.isComplete()
                ? new QueryAnswer(NetVerdict.YES, words + "at most " + most + " tokens", run, graph)
                : new QueryAnswer(
                        NetVerdict.UNKNOWN,
                        words + "up to " + most + " tokens among " + graph.states()
                                + " states: bounded search only, as "
                                + graph.end().words(),
                        run,
                        graph);
    }
}
