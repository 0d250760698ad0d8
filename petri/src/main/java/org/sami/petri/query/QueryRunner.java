package org.sami.petri.query;

import java.util.List;
import java.util.Optional;
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
    private final PetriNet net;
    private final SearchBudget budget;
    private final QueryMeans means;
    private final GraphWatch watch;
    private final LongSupplier nanos;

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

    /** Answers a query about the net. */
    public QueryAnswer answer(NetQuery query) {
        if (query instanceof NetQuery.Reachable reachable) {
            MarkingCondition goal = reachable.condition();
            return found(search(settings(goal).withGoal(goal)), true, "such a marking");
        } else if (query instanceof NetQuery.Invariant invariant) {
            MarkingCondition goal = new Not(invariant.condition());
            return found(search(settings(goal).withGoal(goal)), false, "a marking that breaks it");
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

    /** The settings for a query with a condition: with symmetry where the condition allows it. */
    private SearchSettings settings(MarkingCondition condition) {
        SearchSettings plain = SearchSettings.within(budget);
        return means.symmetry()
                .filter(symmetry -> !symmetry.isEmpty() && ConditionSymmetry.isKept(condition, symmetry))
                .map(plain::withSymmetry)
                .orElse(plain);
    }

    private ReachabilityGraph search(SearchSettings settings) {
        return ReachabilitySearch.explore(net, settings, watch, nanos);
    }

    /** The answer of a search that ends where it finds something. */
    private static QueryAnswer found(ReachabilityGraph graph, boolean whenFound, String what) {
        if (graph.found().isPresent()) {
            FiringSequence run = graph.runTo(graph.found().getAsInt());
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
        if (!means.reduces()) {
            return found(search(settings(goal).withGoal(goal)), true, what);
        }
        QueryAnswer reduced = found(search(settings(goal).withGoal(goal).withReduction()), true, what);
        if (reduced.verdict() != NetVerdict.YES) {
            return reduced;
        }
        QueryAnswer nearest = found(search(settings(goal).withGoal(goal)), true, what);
        return nearest.verdict() == NetVerdict.YES
                ? nearest
                : new QueryAnswer(
                        NetVerdict.YES,
                        reduced.words() + "; there may be a nearer one, which the budget did not find",
                        reduced.witness(),
                        reduced.graph());
    }

    private QueryAnswer home(MarkingCondition condition) {
        ReachabilityGraph graph = search(settings(condition).withEdges());
        if (!graph.isComplete()) {
            return unknown(graph, "not every run was followed to its end");
        }
        if (graph.bytes() + HomeStates.bytes(graph) > budget.bytes()) {
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
        ReachabilityGraph graph =
                search(settings(new LinearComparison(bound.terms(), LinearComparison.Relation.AT_LEAST, 0)));
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
        ReachabilityGraph graph = search(settings(tellsPlaceApart));
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
