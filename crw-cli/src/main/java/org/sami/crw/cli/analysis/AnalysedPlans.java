package org.sami.crw.cli.analysis;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.planspace.PlanFacts;
import org.sami.spn.planspace.PlanQueries;
import org.sami.spn.planspace.PlanQueryAnswer;
import org.sami.spn.planspace.PlanStateWords;

/** Searches plans one after another for the rows of a table. For one thread. */
final class AnalysedPlans {
    private static final PlanQuery STOPS = new PlanQuery("stops", "deadlock", PlanQuery.Expected.NO);
    private static final PlanQuery ENDS = new PlanQuery("can end", "home ended", PlanQuery.Expected.YES);

    private final DomainLibrary library;
    /** So many states times transitions are looked at where nobody says how many states: seconds at most. */
    private static final long MOST_LOOKS = 15_000_000;

    /** A net with more transitions is too large for a table. */
    private static final int MOST_TRANSITIONS = 10_000;

    private final SearchBudget budget;
    private final boolean isOfLooks;
    private final int depth;
    private final GraphWatch watch;

    /**
     * What a table says of a plan with some boats.
     *
     * @param found what the search of its net found; empty where the net is too large
     */
    record Row(Plan plan, int boats, Optional<Found> found, String refusal, long nanos) {}

    /**
     * What the search of a net found.
     *
     * @param saved the answers to the plan's own queries
     * @param never names of transitions that fire in no state
     */
    record Found(
            PlanNet net,
            PlanFacts facts,
            PlanQueryAnswer stops,
            PlanQueryAnswer ends,
            List<PlanQueryAnswer> saved,
            List<String> never) {}

    /**
     * Searches with a budget for each net.
     *
     * @param isOfLooks whether in nets of many transitions fewer states are looked at
     * @param depth how many levels of sub-missions a net follows
     */
    AnalysedPlans(DomainLibrary library, SearchBudget budget, boolean isOfLooks, int depth, GraphWatch watch) {
        this.library = library;
        this.budget = budget;
        this.isOfLooks = isOfLooks;
        this.depth = depth;
        this.watch = watch;
    }

    Row row(Project project, Plan plan, int boats) {
        List<String> robots =
                IntStream.rangeClosed(1, boats).mapToObj(i -> "robot-" + i).toList();
        long begin = System.nanoTime();
        try {
            PlanNet net = PlanNet.smallest(new PlanNetRequest(
                            project,
                            library.vocabulary(),
                            plan.id(),
                            robots,
                            PlanNetRequest.STANDARD_TASKS,
                            isOfLooks ? MOST_TRANSITIONS : PlanNetRequest.STANDARD_TRANSITIONS)
                    .toDepth(depth));
            Found found = found(net, plan);
            return new Row(plan, boats, Optional.of(found), "", System.nanoTime() - begin);
        } catch (PlanNetTooLargeException tooLarge) {
            return new Row(
                    plan, boats, Optional.empty(), String.valueOf(tooLarge.getMessage()), System.nanoTime() - begin);
        }
    }

    private SearchBudget budget(PlanNet net) {
        long states = MOST_LOOKS / Math.max(1, net.net().transitionCount());
        return isOfLooks && states < budget.states()
                ? new SearchBudget((int) Math.max(1, states), budget.bytes(), budget.time())
                : budget;
    }

    private Found found(PlanNet net, Plan plan) {
        PlanQueries queries = new PlanQueries(net, budget(net), watch);
        PlanFacts facts = queries.whole();
        PlanStateWords words = new PlanStateWords(net);
        return new Found(
                net,
                facts,
                queries.answer(STOPS),
                queries.answer(ENDS),
                plan.queries().stream().map(queries::answer).toList(),
                facts.neverFired().stream().map(words::transition).toList());
    }
}
