package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.finding.Severity;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.statespace.DeepChecks;
import org.sami.spn.statespace.DeepRequest;
import org.sami.spn.statespace.DeepResult;
import org.sami.spn.statespace.SearchWatch;

/** Deep checks run on every plan that ships and find nothing wrong: each of these plans was read and run. */
@Tag("long")
class DeepChecksOfShippedPlansTest {
    private static final int STATES = 400;

    static Stream<Map.Entry<Project, Plan>> plans() {
        return TriedPlans.library();
    }

    @ParameterizedTest
    @MethodSource("plans")
    void noPlanOfTheLibraryHasAWarning(Map.Entry<Project, Plan> of) {
        DeepRequest request = new DeepRequest(
                of.getKey(), TriedPlans.LIBRARY.vocabulary(), of.getValue().id(), TriedPlans.robots(2), STATES);

        DeepResult result = DeepChecks.ALL.get(0).run(request, SearchWatch.NONE);

        assertThat(result.states()).isBetween(1, STATES);
        assertThat(result.findings())
                .extracting(found -> found.finding())
                .filteredOn(finding -> finding.severity() != Severity.NOTE)
                .isEmpty();
        assertThat(result.findings())
                .allSatisfy(found -> assertThat(found.finding().plan())
                        .isEqualTo(of.getValue().id()));
    }
}
