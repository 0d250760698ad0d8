package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.spn.model.Plan;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.planspace.PlanQueries;
import org.sami.spn.planspace.PlanQueryAnswer;

/** On the plans of the library, structure proves nothing that a search through the states of their nets does not find. */
@Tag("long")
class StructureFirstOnShippedPlansTest {
    private static final SearchBudget ENOUGH = new SearchBudget(100_000, 256L << 20, Duration.ofMinutes(5));

    static Stream<Map.Entry<Project, Plan>> plans() {
        return TriedPlans.library();
    }

    @ParameterizedTest
    @MethodSource("plans")
    void proofsByStructureAndSearchesGiveTheSameAnswers(Map.Entry<Project, Plan> of) throws PlanNetTooLargeException {
        Plan plan = of.getValue();
        PlanNet net = PlanNet.smallest(
                new PlanNetRequest(of.getKey(), TriedPlans.LIBRARY.vocabulary(), plan.id(), TriedPlans.robots(2)));
        Stream<PlanQuery> asked = Stream.concat(
                plan.queries().stream(),
                Stream.concat(
                                Stream.of("deadlock"),
                                plan.places().stream().map(place -> "reachable m(\"" + place.id() + "\".robots) >= 3"))
                        .map(text -> new PlanQuery(text, text, PlanQuery.Expected.NO)));

        List<PlanQuery> queries = asked.filter(query -> new PlanQueries(net, ENOUGH, GraphWatch.NONE)
                        .fault(query.text())
                        .isEmpty())
                .toList();
        assertThat(queries).isNotEmpty();
        for (PlanQuery query : queries) {
            PlanQueryAnswer first = new PlanQueries(net, ENOUGH, GraphWatch.NONE).answer(query);
            PlanQueryAnswer searched = new PlanQueries(net, ENOUGH, GraphWatch.NONE, false).answer(query);
            assertThat(first.verdict()).as(query.text()).isEqualTo(searched.verdict());
            assertThat(first.result()).as(query.text()).isEqualTo(searched.result());
        }
    }
}
