package org.sami.dreamm.tryout;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
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

    @ParameterizedTest
    @MethodSource("plans")
    void everyPlanRunsToItsEnd(Map.Entry<Project, Plan> of) {
        TryOut tryOut = new TryOut(new ProjectDocument(LIBRARY.vocabulary(), of.getKey(), Optional.empty()));
        assertThat(tryOut.start(of.getValue().id())).as(tryOut.message()).isTrue();

        int steps = 0;
        while (steps < MOST && !tryOut.isOver() && tryOut.stepOn()) {
            steps++;
        }

        assertThat(tryOut.stepper().flatMap(Stepper::outcome))
                .as("%s: %s\n%s", of.getValue().id(), tryOut.message(), tryOut.lines())
                .contains(Outcome.ENDED);
    }
}
