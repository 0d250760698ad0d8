package org.sami.spn.planspace;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.sami.petri.coverability.SaturatedQueries;
import org.sami.petri.coverability.SaturatedSearch;
import org.sami.petri.coverability.WiderNet;
import org.sami.petri.graph.FiringSequence;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.MarkingTest;
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
import org.sami.petri.symmetry.NetSymmetry;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.TestCase;
import org.sami.spn.plannet.Abstraction;
import org.sami.spn.plannet.PlanMarking;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetFiring;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.plannet.PlanRun;

/**
 * Answers the queries of a plan by searches of its net, by symmetry where a query names no robot, and takes the runs that it finds on the engine. For one thread.
 */
public final class PlanQueries {
    /** So many steps of the engine are tried for one run: some seconds at most. */
    private static final int MOST_STEPS = 20_000;

    /** A net with more transitions is large. */
    private static final int LARGE = 1_000;

    /** So many states are looked at before a query is searched for alone. */
    private static final int FIRST_STATES = 50_000;

    private final PlanNet net;
    private final PlanNetNames names;
    private final QueryRunner runner;
    private final RunOnEngine engine;
    private final NetSymmetry symmetry;
    private final SearchBudget budget;
    private final GraphWatch watch;
    private Optional<SaturatedQueries> saturated = Optional.empty();
    private Optional<PlanQueries> named = Optional.empty();
    private int looked;

    /**
     * Queries about a plan's net. Where it counts robots, queries that name one are asked of the net that names them; where it follows only whether there are any, all
     * queries that this does not answer.
     *
     * @param budget of each search
     */
    public PlanQueries(PlanNet net, SearchBudget budget, GraphWatch watch) {
        this.net = net;
        names = new PlanNetNames(net);
        // without stubborn sets: each end takes the place "running", which every transition needs, so none is
        // independent of all others
        symmetry = symmetry(net.net());
        QueryMeans means = new QueryMeans(false, Optional.of(symmetry));
        runner = new QueryRunner(net.net(), budget, means, watch, System::nanoTime);
        this.budget = budget;
        this.watch = watch;
        engine = new RunOnEngine(net, MOST_STEPS, watch::isCancelled);
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
            named = Optional.of(new PlanQueries(PlanNet.of(net.request()), budget, watch));
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

    private PlanQueryAnswer answer(PlanQuery query, NetQuery asked) {
        look(Math.min(FIRST_STATES, budget.states()));
        Optional<QueryAnswer> without = saturated.flatMap(few -> few.answer(asked));
        if (without.isEmpty() && net.isPresent()) {
            return answerByName(query);
        }
        QueryAnswer found = without.orElseGet(() -> runner.answer(asked));
        boolean happens = isThatItHappens(asked, found);
        boolean isAProof = found.verdict() != NetVerdict.UNKNOWN && (happens || isWhole(found));
        Optional<PlanWitness> witness = found.witness().map(run -> witness(run, query, goal(asked, run)));
        boolean isOfThePlan = isAProof && (isExact() || !isOnlyAllowed(asked, found, happens, witness));
        return new PlanQueryAnswer(
                query,
                isOfThePlan ? result(query, found.verdict()) : PlanQueryAnswer.Result.OPEN,
                isAProof ? found.verdict() : NetVerdict.UNKNOWN,
                isOfThePlan && asked.isFault(found.verdict()),
                found.verdict().name().toLowerCase(Locale.ROOT) + ": " + found.words()
                        + (isAProof ? caution(asked, found, happens, witness) : notWhole(found)),
                witness,
                found.graph().states(),
                found.graph().nanos());
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
        return found.graph().mostTokens(net.beyond()) == 0
                && net.abstractions().stream().noneMatch(a -> a.kind() == Abstraction.Kind.PARTIAL);
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
            return ", if what is waited for comes";
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

    private PlanWitness witness(FiringSequence run, PlanQuery query, MarkingTest goal) {
        Optional<TestCase> steps = engine.steps(run, goal, query.name());
        PlanRun named = net.run(run);
        List<PlanNetFiring> firings = named.firings();
        List<PlanMarking> markings = named.markings();
        PlanStateWords words = new PlanStateWords(net);
        return new PlanWitness(
                firings,
                markings,
                firings.stream().map(words::moves).toList(),
                words.marked(markings.get(markings.size() - 1)),
                steps);
    }

    /** What the engine has to come to: what was asked for; where that is about all that follows, the end of the run itself. */
    private MarkingTest goal(NetQuery asked, FiringSequence run) {
        if (asked instanceof NetQuery.Reachable reachable) {
            return reachable.condition();
        } else if (asked instanceof NetQuery.Invariant invariant) {
            return marking -> !invariant.condition().test(marking);
        }
        int[] end = run.replay(net.net());
        return marking -> Arrays.equals(marking, end);
    }
}
