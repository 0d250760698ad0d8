package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/** The two plans of thesis 8.1, generic and marked up: what differs between their runs is due to markup alone. */
class MarkedUpPlanTest {
    private static final Project PROJECT = DomainLibrary.fromClassPath("/org/sami/domain/crw")
            .orThrow()
            .projectOf("explore-marked")
            .orElseThrow();

    private static Plan plan(String id) {
        return PROJECT.plan(id).orElseThrow();
    }

    private static Stream<OutputEventSpec> outputs(Plan plan) {
        return plan.places().stream().flatMap(place -> place.outputs().stream());
    }

    private static List<Object> asked(Plan plan) {
        return outputs(plan)
                .<Object>map(output -> List.of(output.id(), output.type(), output.fields()))
                .toList();
    }

    @Test
    void theyDifferInMarkupAlone() {
        Plan generic = plan("explore-generic");
        Plan marked = plan("explore-marked");

        assertThat(marked.inEdges()).isEqualTo(generic.inEdges());
        assertThat(marked.outEdges()).isEqualTo(generic.outEdges());
        assertThat(marked.transitions()).isEqualTo(generic.transitions());
        assertThat(asked(marked)).isEqualTo(asked(generic));
        assertThat(outputs(marked).mapToLong(output -> output.markups().size()).sum())
                .isGreaterThan(outputs(generic)
                        .mapToLong(output -> output.markups().size())
                        .sum());
    }
}
