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
    private final SearchBudget budget;
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

    AnalysedPlans(DomainLibrary library, SearchBudget budget, GraphWatch watch) {
        this.library = library;
        this.budget = budget;
        this.watch = watch;
    }

    Row row(Project project, Plan plan, int boats) {
        List<String> robots =
                IntStream.rangeClosed(1, boats).mapToObj(i -> "robot-" + i).toList();
        long begin = System.nanoTime();
        try {
            PlanNet net = PlanNet.smallest(new PlanNetRequest(project, library.vocabulary(), plan.id(), robots));
            Found found = found(net, plan);
            return new Row(plan, boats, Optional.of(found), "", System.nanoTime() - begin);
        } catch (PlanNetTooLargeException tooLarge) {
            return new Row(
                    plan, boats, Optional.empty(), String.valueOf(tooLarge.getMessage()), System.nanoTime() - begin);
        }
    }

    private Found found(PlanNet net, Plan plan) {
        PlanQueries queries = new PlanQueries(net, budget, watch);
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
