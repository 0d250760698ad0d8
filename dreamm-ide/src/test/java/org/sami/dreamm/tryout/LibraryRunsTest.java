package org.sami.dreamm.tryout;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.stepping.Stepper;

/** What an author sees who starts a plan of the library and presses Run. */
class LibraryRunsTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final int MOST = 400;

    static Stream<Map.Entry<Project, Plan>> plans() {
        return LIBRARY.projects().values().stream()
                .flatMap(project -> project.plans().stream().map(plan -> Map.entry(project, plan)));
    }

    private static TryOut runToItsEnd(Project project, String plan) {
        TryOut tryOut = new TryOut(new ProjectDocument(LIBRARY.vocabulary(), project, Optional.empty()));
        assertThat(tryOut.start(plan)).as(tryOut.message()).isTrue();
        int steps = 0;
        while (steps < MOST && !tryOut.isOver() && tryOut.stepOn()) {
            steps++;
        }
        return tryOut;
    }

    @Test
    void whatLedOutOfARoundIsSaid() {
        String plan = "communications-monitoring";

        TryOut tryOut = runToItsEnd(LIBRARY.projectOf(plan).orElseThrow(), plan);

        assertThat(tryOut.message())
                .isEqualTo(
                        "it went round; press end monitoring leads out: fired End monitoring; mission 1 is over: ended");
        assertThat(tryOut.lines().get(tryOut.steps() - 1).done()).isEqualTo("press end monitoring (it went round)");
    }

    @ParameterizedTest
    @MethodSource("plans")
    void everyPlanRunsToItsEnd(Map.Entry<Project, Plan> of) {
        TryOut tryOut = runToItsEnd(of.getKey(), of.getValue().id());

        assertThat(tryOut.stepper().flatMap(Stepper::outcome))
                .as("%s: %s\n%s", of.getValue().id(), tryOut.message(), tryOut.lines())
                .contains(Outcome.ENDED);
    }
}
