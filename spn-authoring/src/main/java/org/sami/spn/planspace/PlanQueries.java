package org.sami.spn.planspace;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.sami.petri.coverability.SaturatedQueries;
import org.sami.petri.coverability.SaturatedSearch;
import org.sami.petri.coverability.WiderNet;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.NetQuery;
import org.sami.petri.query.QueryAnswer;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.petri.query.QueryFaultException;
import org.sami.petri.query.QueryMeans;
import org.sami.petri.query.QueryParser;
import org.sami.petri.query.QueryRunner;
import org.sami.petri.structure.StructuralQueries;
import org.sami.petri.symmetry.NetSymmetry;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.plannet.Abstraction;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetTooLargeException;

/**
 * Answers the queries of a plan by the structure of its net, and, where that does not tell, by searches of the net, by symmetry where a query names no robot, and takes the runs that it finds on the engine. For one thread.
 */
public final class PlanQueries {
    /** A net with more transitions is large. */
    private static final int LARGE = 1_000;

    /** So many states are looked at before a query is searched for alone. */
    private static final int FIRST_STATES = 50_000;

    private static final String IF_IT_COMES = ", if what is waited for comes";

    private static final String SUB_MISSIONS_OPEN =
            "; what sub-missions do was left open, as the search that followed them did not tell";

    private final PlanNet net;
    private final PlanNetNames names;
    private final QueryRunner runner;
    private final Witnesses witnesses;
    private final Optional<PlanProofs> proofs;
    private final NetSymmetry symmetry;
    private final SearchBudget budget;
    private final GraphWatch watch;
    private final boolean structure;
    private Optional<SaturatedQueries> saturated = Optional.empty();
    private Optional<PlanQueries> named = Optional.empty();
    private Optional<PlanQueries> opened = Optional.empty();
    private int looked;

    /**
     * Queries about a plan's net. Where it counts robots, queries that name one are asked of the net that names them; where it follows only whether there are any, all
     * queries that this does not answer. Where it follows sub-missions and its search does not tell, they are asked of the smaller net that leaves these open.
     *
     * @param budget of each search
     */
    public PlanQueries(PlanNet net, SearchBudget budget, GraphWatch watch) {
        this(net, budget, watch, true);
    }

    /**
     * The same, where it can be said that structure is left out.
     *
     * @param structure whether the structure of the net is asked before its states are searched; the answers are the same
     */
    public PlanQueries(PlanNet net, SearchBudget budget, GraphWatch watch, boolean structure) {
        this.net = net;
        names = new PlanNetNames(net);
        // without stubborn sets: each end takes the place "running", which every transition needs, so none is
        // independent of all others
        symmetry = symmetry(net.net());
        QueryMeans means = new QueryMeans(false, Optional.of(symmetry));
        runner = new QueryRunner(net.net(), budget, means, watch, System::nanoTime);
        this.budget = budget;
        this.watch = watch;
        witnesses = new Witnesses(net, budget.states(), watch::isCancelled);
        proofs = structure ? Optional.of(new PlanProofs(net, watch::isCancelled)) : Optional.empty();
        this.structure = structure;
    }

    /** Where robots are counted, and in a large net, the exchanges that are known are all that is looked for. */
    private NetSymmetry symmetry(PetriNet of) {
        return !net.hasNames() || of.transitionCount() > LARGE
                ? NetSymmetry.of(of, net.exchanges())
                : NetSymmetry.of(of);
    }

    /** What is wrong with the text of a query; empty where it means something. */
    public Optional<String> fault(String text) {
        try {
            QueryParser.query(net.net(), names, text);
            return Optional.empty();
        } catch (QueryFaultException fault) {
            try {
                return !net.hasNames() ? byName().fault(text) : Optional.of(fault.words());
            } catch (PlanNetTooLargeException tooLarge) {
                return Optional.of(fault.words());
            }
        }
    }

    /** Queries about the net in which robots have names. */
    private PlanQueries byName() throws PlanNetTooLargeException {
        if (named.isEmpty()) {
            named = Optional.of(new PlanQueries(PlanNet.of(net.request()), budget, watch, structure));
        }
        return named.get();
    }

    /** All states up to an exchange of robots, as far as the budget goes; later queries are answered from them. Where tokens gather, up to how many there are. */
    public PlanFacts whole() {
        look(budget.states());
        if (saturated.isEmpty() && net.isPresent()) {
            try {
                return byName().whole();
            } catch (PlanNetTooLargeException tooLarge) {
                return PlanFacts.of(net, runner.whole());
            }
        }
        return saturated.map(few -> PlanFacts.of(net, few)).orElseGet(() -> PlanFacts.of(net, runner.whole()));
    }

    /** One search for all queries, as far as so many states. */
    private void look(int states) {
        if (looked >= states || saturated.isPresent()) {
            return;
        }
        boolean isAll = states >= budget.states();
        looked = states;
        SaturatedSearch search = new SaturatedSearch(
                new WiderNet(net.net(), net.presence(), net.sure()),
                net.uncounted(),
                new SearchBudget(states, budget.bytes(), budget.time()),
                of -> of == net.net() ? symmetry : symmetry(of),
                watch,
                System::nanoTime);
        ReachabilityGraph graph = search.exact();
        if (graph.found().isPresent() || (net.isPresent() && graph.isComplete())) {
            saturated = search.saturated(graph);
            if (saturated.isEmpty() && isAll && !net.isPresent()) {
                runner.know(runner.whole());
            }
        } else if (!net.isPresent() && (isAll || graph.isComplete())) {
            looked = budget.states();
            runner.know(graph);
        }
    }

    /** Answers one query. */
    public PlanQueryAnswer answer(PlanQuery query) {
        try {
            return answer(query, QueryParser.query(net.net(), names, query.text()));
        } catch (QueryFaultException fault) {
            return !net.hasNames()
                    ? answerByName(query)
                    : PlanQueryAnswer.without(query, PlanQueryAnswer.Result.FAULT, fault.words());
        }
    }

    private PlanQueryAnswer answerByName(PlanQuery query) {
        try {
            return byName().answer(query);
        } catch (PlanNetTooLargeException tooLarge) {
            return PlanQueryAnswer.without(query, PlanQueryAnswer.Result.OPEN, "unknown: " + tooLarge.getMessage());
        }
    }

    /** What the smaller net says that leaves open what sub-missions do; empty where that does not tell either, or cannot be asked. */
    private Optional<PlanQueryAnswer> answerWithSubMissionsOpen(PlanQuery query) {
        try {
            if (opened.isEmpty()) {
                PlanNet smaller = PlanNet.smallest(net.request().toDepth(0));
                opened = Optional.of(new PlanQueries(smaller, budget, watch, structure));
            }
            return Optional.of(opened.get().answer(query))
                    .filter(answer -> answer.verdict() != NetVerdict.UNKNOWN)
                    .map(answer -> answer.adding(SUB_MISSIONS_OPEN));
        } catch (PlanNetTooLargeException tooLarge) {
            return Optional.empty();
        }
    }

    private PlanQueryAnswer answer(PlanQuery query, NetQuery asked) {
        Optional<StructuralQueries.Answer> proved =
                looked >= budget.states() ? Optional.empty() : proofs.flatMap(some -> some.answer(asked));
        if (proved.isPresent()) {
            return proved(query, asked, proved.get());
        }
        look(Math.min(FIRST_STATES, budget.states()));
        Optional<QueryAnswer> without = saturated.flatMap(few -> few.answer(asked));
        if (without.isEmpty() && net.isPresent()) {
            return answerByName(query);
        }
        QueryAnswer found = without.orElseGet(() -> runner.answer(asked));
        if (found.verdict() == NetVerdict.UNKNOWN && net.followsSubMissions() && !watch.isCancelled()) {
            Optional<PlanQueryAnswer> open = answerWithSubMissionsOpen(query);
            if (open.isPresent()) {
                return open.get();
            }
        }
        boolean happens = isThatItHappens(asked, found);
        boolean isWhole = isWhole(found);
        boolean mayComeHome = happens && asked instanceof NetQuery.Home && !isWhole; // on a way that the net lacks
        boolean isAProof = found.verdict() != NetVerdict.UNKNOWN && (happens || isWhole);
        Optional<PlanWitness> witness = found.witness().map(run -> witnesses.of(run, query, asked));
        boolean isOfThePlan = isAProof && !mayComeHome && (isExact() || !isOnlyAllowed(asked, found, happens, witness));
        return new PlanQueryAnswer(
                query,
                isOfThePlan ? result(query, found.verdict()) : PlanQueryAnswer.Result.OPEN,
                isAProof ? found.verdict() : NetVerdict.UNKNOWN,
                isOfThePlan && asked.isFault(found.verdict()),
                found.verdict().name().toLowerCase(Locale.ROOT) + ": " + found.words()
                        + (isAProof && !mayComeHome ? caution(asked, found, happens, witness) : notWhole(found)),
                witness,
                List.of(),
                found.graph().states(),
                found.graph().nanos());
    }

    private PlanQueryAnswer proved(PlanQuery query, NetQuery asked, StructuralQueries.Answer answer) {
        String ifItComes = asked instanceof NetQuery.Deadlock && !isExact() ? IF_IT_COMES : "";
        return PlanQueryAnswer.proved(
                query, result(query, answer.verdict()), answer.verdict(), answer.proof(), ifItComes);
    }

    private static PlanQueryAnswer.Result result(PlanQuery query, NetVerdict verdict) {
        return query.expected().name().equals(verdict.name())
                ? PlanQueryAnswer.Result.EXPECTED
                : PlanQueryAnswer.Result.UNEXPECTED;
    }

    /**
     * Whether the answer is that something happens, to which a run leads. That there is no way home after a run is shown by a whole net only, as another may lack ways
     * that the plan has.
     */
    private static boolean isThatItHappens(NetQuery asked, QueryAnswer found) {
        boolean isYes = found.verdict() == NetVerdict.YES;
        return (asked instanceof NetQuery.Reachable || asked instanceof NetQuery.Deadlock)
                ? isYes
                : (asked instanceof NetQuery.Invariant || asked instanceof NetQuery.Home) && !isYes;
    }

    /** Whether the answer says what a net that is wider than its plan does, and the engine was not seen to do it. */
    private static boolean isOnlyAllowed(
            NetQuery asked, QueryAnswer found, boolean happens, Optional<PlanWitness> witness) {
        return isWithoutBound(asked, found)
                || (happens && witness.flatMap(PlanWitness::steps).isEmpty());
    }

    private static boolean isWithoutBound(NetQuery asked, QueryAnswer found) {
        return found.verdict() == NetVerdict.NO
                && (asked instanceof NetQuery.Bound || asked instanceof NetQuery.BoundOfSum);
    }

    /** Whether the net follows all that the plan can do. */
    private boolean isWhole(QueryAnswer found) {
        return found.graph().mostTokens(net.beyond()) == 0 && !net.isPartial();
    }

    private String notWhole(QueryAnswer found) {
        if (found.verdict() == NetVerdict.UNKNOWN) {
            return "";
        }
        if (found.graph().mostTokens(net.beyond()) > 0) {
            return "; no proof, as more tokens gather in a place than the search follows";
        }
        return net.abstractions().stream()
                .filter(a -> a.kind() == Abstraction.Kind.PARTIAL)
                .findFirst()
                .map(a -> "; no proof: " + a.text())
                .orElse("");
    }

    /** Whether the plan itself does what the net does. */
    private String caution(NetQuery asked, QueryAnswer found, boolean happens, Optional<PlanWitness> witness) {
        boolean goesOn = !happens && (asked instanceof NetQuery.Deadlock || asked instanceof NetQuery.Home);
        if (goesOn && !isExact()) {
            return IF_IT_COMES;
        }
        if (isWithoutBound(asked, found) && !isExact()) {
            return "; it may be so: the net leaves open what data decide";
        }
        if (!happens || witness.isEmpty()) {
            return "";
        }
        return witness.get()
                .steps()
                .map(steps -> ", and the engine comes there by "
                        + (steps.steps().isEmpty()
                                ? "its start"
                                : counted(steps.steps().size(), "step")))
                .orElse(
                        isExact()
                                ? ""
                                : "; it may be so: the engine was not seen to do it, as the net leaves open what data"
                                        + " decide");
    }

    private static String counted(int count, String noun) {
        return count + " " + noun + (count == 1 ? "" : "s");
    }

    private boolean isExact() {
        return net.abstractions().stream().noneMatch(a -> a.kind() == Abstraction.Kind.WIDER);
    }
}
