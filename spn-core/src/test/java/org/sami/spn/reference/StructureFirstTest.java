package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.spn.model.Place;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.planspace.PlanQueries;
import org.sami.spn.planspace.PlanQueryAnswer;
import org.sami.spn.testing.TestVocabulary;

/** What the structure of a plan's net proves is what a search through its states finds, on random plans. */
class StructureFirstTest {
    private static final long SEEDS = 40;
    private static final SearchBudget SMALL = new SearchBudget(400, 64L << 20, Duration.ofMinutes(15));

    private final AtomicInteger compared = new AtomicInteger();
    private final AtomicInteger proved = new AtomicInteger();

    @Test
    void proofsByStructureAndSearchesGiveTheSameAnswers() {
        List<String> differences = LongStream.rangeClosed(1, SEEDS)
                .boxed()
                .flatMap(seed -> Stream.of(NewsPlans.project(seed), CopyPlans.project(seed))
                        .flatMap(project -> differences(seed, project).stream()))
                .toList();

        assertThat(differences).isEmpty();
        assertThat(compared.get()).isGreaterThan(500);
        assertThat(proved.get()).isGreaterThan(50);
    }

    private List<String> differences(long seed, Project project) {
        List<String> found = new ArrayList<>();
        try {
            PlanNet net = PlanNet.smallest(new PlanNetRequest(project, TestVocabulary.TEST, "main", List.of("A", "B")));
            PlanQueries search = new PlanQueries(net, SMALL, GraphWatch.NONE, false);
            for (String text : queries(project)) {
                PlanQuery query = new PlanQuery("q", text, PlanQuery.Expected.NO);
                PlanQueryAnswer first = new PlanQueries(net, SMALL, GraphWatch.NONE).answer(query);
                PlanQueryAnswer searched = search.answer(query);
                compared.incrementAndGet();
                boolean byStructure = first.words().contains("proved by");
                proved.addAndGet(byStructure ? 1 : 0);
                boolean isSame = first.verdict() == searched.verdict() && first.result() == searched.result();
                boolean provesMore = byStructure && searched.verdict() == NetVerdict.UNKNOWN;
                if (!isSame && !provesMore) {
                    found.add("seed " + seed + ", " + text + ": " + first.words() + ", but " + searched.words());
                }
            }
        } catch (PlanNetTooLargeException e) {
            return List.of();
        }
        return found;
    }

    private static List<String> queries(Project project) {
        List<String> queries = new ArrayList<>(List.of("deadlock", "home ended"));
        for (Place place : project.plan("main").orElseThrow().places()) {
            String here = "m(\"" + place.id() + "\")";
            queries.add("reachable " + here + " >= 3");
            queries.add("invariant " + here + " <= 1");
        }
        return queries;
    }
}
