package org.sami.spn.planspace;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.sami.petri.graph.FiringSequence;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.net.FiringRule;
import org.sami.petri.query.NetQuery;
import org.sami.petri.query.QueryAnswer;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.petri.query.QueryFaultException;
import org.sami.petri.query.QueryMeans;
import org.sami.petri.query.QueryParser;
import org.sami.petri.query.QueryRunner;
import org.sami.petri.symmetry.NetSymmetry;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.plannet.Abstraction;
import org.sami.spn.plannet.PlanMarking;
import org.sami.spn.plannet.PlanNet;

/** Answers the queries of a plan by searches of its net, by symmetry where a query names no robot. For one thread. */
public final class PlanQueries {
    private final PlanNet net;
    private final PlanNetNames names;
    private final QueryRunner runner;

    /**
     * Queries about a plan's net.
     *
     * @param budget of each search
     */
    public PlanQueries(PlanNet net, SearchBudget budget, GraphWatch watch) {
        this.net = net;
        names = new PlanNetNames(net);
        QueryMeans means = new QueryMeans(true, Optional.of(NetSymmetry.of(net.net())));
        runner = new QueryRunner(net.net(), budget, means, watch, System::nanoTime);
    }

    /** Answers one query. */
    public PlanQueryAnswer answer(PlanQuery query) {
        NetQuery asked;
        try {
            asked = QueryParser.query(net.net(), names, query.text());
        } catch (QueryFaultException fault) {
            return new PlanQueryAnswer(query, PlanQueryAnswer.Result.FAULT, fault.words(), List.of(), List.of());
        }
        QueryAnswer found = runner.answer(asked);
        boolean isAProof = found.verdict() != NetVerdict.UNKNOWN && (isThatItHappens(asked, found) || isWhole(found));
        String words = found.verdict() == NetVerdict.UNKNOWN
                ? "unknown: " + found.words()
                : found.verdict().name().toLowerCase(Locale.ROOT) + ": " + found.words();
        return new PlanQueryAnswer(
                query,
                isAProof ? result(query, found.verdict()) : PlanQueryAnswer.Result.OPEN,
                isAProof ? words + caution(isThatItHappens(asked, found)) : words + notWhole(found),
                found.witness().map(net::firings).orElse(List.of()),
                found.witness().map(this::markings).orElse(List.of()));
    }

    private static PlanQueryAnswer.Result result(PlanQuery query, NetVerdict verdict) {
        return query.expected().name().equals(verdict.name())
                ? PlanQueryAnswer.Result.EXPECTED
                : PlanQueryAnswer.Result.UNEXPECTED;
    }

    /** Whether the answer is that something happens, which a run shows. */
    private static boolean isThatItHappens(NetQuery asked, QueryAnswer found) {
        boolean isYes = found.verdict() == NetVerdict.YES;
        return (asked instanceof NetQuery.Reachable || asked instanceof NetQuery.Deadlock)
                ? isYes
                : (asked instanceof NetQuery.Invariant || asked instanceof NetQuery.Home) && !isYes;
    }

    /** Whether the net follows all that the plan can do. */
    private boolean isWhole(QueryAnswer found) {
        return found.graph().mostTokens(net.beyond()) == 0
                && net.abstractions().stream().noneMatch(a -> a.kind() == Abstraction.Kind.PARTIAL);
    }

    private String notWhole(QueryAnswer found) {
        if (found.graph().mostTokens(net.beyond()) > 0) {
            return "; no proof, as more tokens gather in a place than the search follows";
        }
        return net.abstractions().stream()
                .filter(a -> a.kind() == Abstraction.Kind.PARTIAL)
                .findFirst()
                .map(a -> "; no proof: " + a.text())
                .orElse("");
    }

    /** What makes a run that the net has doubtful on the engine. */
    private String caution(boolean isThatItHappens) {
        long wider = net.abstractions().stream()
                .filter(a -> a.kind() == Abstraction.Kind.WIDER)
                .count();
        return isThatItHappens && wider > 0
                ? "; " + (wider == 1 ? "1 thing that data decide was" : wider + " things that data decide were")
                        + " left open on the way"
                : "";
    }

    private List<PlanMarking> markings(FiringSequence run) {
        int[] marking = net.net().initialMarking();
        List<PlanMarking> markings = new ArrayList<>(List.of(net.marking(marking)));
        for (int transition : run.transitions()) {
            marking = FiringRule.fire(net.net(), transition, marking);
            markings.add(net.marking(marking));
        }
        return markings;
    }
}
