package org.sami.petri.coverability;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sami.petri.graph.HomeStates;
import org.sami.petri.graph.MarkingTest;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.net.FiringRule;
import org.sami.petri.query.LinearComparison;
import org.sami.petri.query.MarkingCondition;
import org.sami.petri.query.NetQuery;
import org.sami.petri.query.QueryAnswer;
import org.sami.petri.query.QueryAnswer.NetVerdict;

/**
 * Answers queries about a net, which may have infinitely many markings, from the whole graph of its {@link SaturatedNet}: that something never happens, that from
 * everywhere there is a way to some markings, and bounds from above. For one thread.
 */
public final class SaturatedQueries {
    private final WiderNet wider;
    private final SaturatedNet saturated;
    private final ReachabilityGraph graph;
    private final long bytes;

    /**
     * Answers from a graph.
     *
     * @param wider the net that is saturated
     * @param graph complete, with the edges of firings that are sure in both
     * @param bytes how much memory the graph and a search for ways back through it may take; where it does not suffice, nothing is said of such ways
     */
    public SaturatedQueries(WiderNet wider, SaturatedNet saturated, ReachabilityGraph graph, long bytes) {
        this.wider = wider;
        this.saturated = saturated;
        this.graph = graph;
        this.bytes = bytes;
    }

    /** What was searched. */
    public ReachabilityGraph graph() {
        return graph;
    }

    /** The net whose graph it is. */
    public SaturatedNet net() {
        return saturated;
    }

    /** The answer; empty where the graph does not tell. */
    public Optional<QueryAnswer> answer(NetQuery query) {
        if (query instanceof NetQuery.Reachable reachable) {
            return never(reachable.condition(), NetVerdict.NO, "such a marking");
        } else if (query instanceof NetQuery.Invariant invariant) {
            return never(new MarkingCondition.Not(invariant.condition()), NetVerdict.YES, "a marking that breaks it");
        } else if (query instanceof NetQuery.Deadlock deadlock) {
            return speaks(deadlock.end())
                    ? Optional.empty()
                    : deadlocks(deadlock.end())
                            ? Optional.empty()
                            : Optional.of(answer(NetVerdict.NO, "a deadlock is never reached"));
        } else if (query instanceof NetQuery.Home home) {
            return speaks(home.condition())
                            || !HomeStates.fits(graph, bytes)
                            || HomeStates.of(graph, home.condition())
                                    .firstWithout()
                                    .isPresent()
                    ? Optional.empty()
                    : Optional.of(answer(
                            NetVerdict.YES,
                            "from each of the " + graph.states() + " states such a marking can be reached"));
        } else if (query instanceof NetQuery.Bound bound) {
            return isNotCounted(bound.place())
                    ? Optional.empty()
                    : Optional.of(answer(
                            NetVerdict.YES,
                            "place " + graph.net().placeId(bound.place()) + " has at most "
                                    + graph.mostTokens(bound.place()) + " tokens"));
        }
        return query instanceof NetQuery.BoundOfSum bound ? bound(bound) : Optional.empty();
    }

    private QueryAnswer answer(NetVerdict verdict, String words) {
        String where =
                saturated.places().stream().mapToObj(graph.net()::placeId).collect(Collectors.joining(", "));
        return new QueryAnswer(
                verdict,
                words
                        + (where.isEmpty() ? "" : ", however many tokens are in " + where)
                        + (wider.presence().isEmpty()
                                ? ""
                                : ", with " + wider.presence().cardinality()
                                        + " places of which it was followed only whether they have tokens"),
                Optional.empty(),
                graph);
    }

    private Optional<QueryAnswer> never(MarkingCondition condition, NetVerdict verdict, String what) {
        return speaks(condition) || graph.first(condition).isPresent()
                ? Optional.empty()
                : Optional.of(answer(verdict, what + " is never reached"));
    }

    /** Whether there may be a marking in which nothing is enabled that is sure. */
    private boolean deadlocks(MarkingTest end) {
        return wider.isExact()
                ? graph.deadlocks().stream().map(graph::marking).anyMatch(marking -> !end.test(marking))
                : IntStream.range(0, graph.states())
                        .mapToObj(graph::marking)
                        .anyMatch(marking -> !end.test(marking) && !isSomethingSure(marking));
    }

    private boolean isSomethingSure(int[] marking) {
        return IntStream.range(0, graph.net().transitionCount())
                .filter(t -> wider.isSure(saturated.original(t)))
                .anyMatch(t -> FiringRule.isEnabled(graph.net(), t, marking));
    }

    private boolean isNotCounted(int place) {
        return saturated.places().get(place) || wider.presence().get(place);
    }

    private Optional<QueryAnswer> bound(NetQuery.BoundOfSum bound) {
        if (bound.terms().stream().anyMatch(term -> isNotCounted(term.place()))) {
            return Optional.empty();
        }
        long most = Long.MIN_VALUE;
        for (int state = 0; state < graph.states(); state++) {
            most = Math.max(most, bound.of(graph.marking(state)));
        }
        return Optional.of(answer(NetVerdict.YES, bound.text() + " is at most " + most));
    }

    /**
     * Whether a condition speaks of more than the graph tells: of a place that gathers tokens, of how many are in a place of which it says only whether it has any, or of
     * what a transition needs.
     */
    private boolean speaks(MarkingCondition condition) {
        if (condition instanceof MarkingCondition.All all) {
            return speaks(all.parts());
        } else if (condition instanceof MarkingCondition.Any any) {
            return speaks(any.parts());
        } else if (condition instanceof MarkingCondition.Not not) {
            return speaks(not.part());
        } else if (condition instanceof LinearComparison comparison) {
            return comparison.terms().stream()
                    .anyMatch(term -> saturated.places().get(term.place())
                            || (wider.presence().get(term.place()) && !comparison.isOfPresence()));
        }
        return true;
    }

    private boolean speaks(List<MarkingCondition> parts) {
        return parts.stream().anyMatch(this::speaks);
    }
}
