package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.analysis.space.DeepCheck;
import org.sami.spn.analysis.space.DeepFinding;
import org.sami.spn.analysis.space.DeepRequest;
import org.sami.spn.analysis.space.DeepResult;
import org.sami.spn.analysis.space.SearchWatch;
import org.sami.spn.engine.Engine;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.TakenStep;

/** Deep checks run on every plan that ships, and what they bring as a witness can be saved and played. */
class DeepChecksOfShippedPlansTest {
    private static final int STATES = 60;
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    static Stream<Map.Entry<Project, Plan>> plans() {
        return LIBRARY.projects().values().stream()
                .flatMap(project -> project.plans().stream().map(plan -> Map.entry(project, plan)));
    }

    @ParameterizedTest
    @MethodSource("plans")
    void witnessesArePlayedToTheMarkingThatTheyAreAbout(Map.Entry<Project, Plan> of) {
        Project project = of.getKey();
        Plan plan = of.getValue();
        DeepRequest request = new DeepRequest(project, LIBRARY.vocabulary(), plan.id(), List.of("b1", "b2"), STATES);
        for (DeepCheck check : DeepCheck.ALL) {
            DeepResult result = check.run(request, SearchWatch.NONE);

            assertThat(result.states()).isBetween(1, STATES);
            for (DeepFinding found : result.findings()) {
                assertThat(found.finding().plan()).isEqualTo(plan.id());
                found.witness().ifPresent(witness -> assertPlays(project, plan, found, witness));
            }
        }
    }

    private static void assertPlays(Project project, Plan plan, DeepFinding found, TestCase witness) {
        Stepper stepper = Stepper.startAs(new Engine(LIBRARY.vocabulary(), project), plan.id(), witness);
        witness.steps().forEach(step -> {
            TakenStep taken = stepper.take(step);
            assertThat(taken.refusal()).as("%s of %s", step, witness.name()).isEmpty();
        });
        stepper.view()
                .mission(stepper.mission())
                .ifPresent(mission -> assertThat(List.copyOf(mission.marking().keySet()))
                        .isEqualTo(found.finding().elements()));
        Plan kept = plan.withTestCases(List.of(witness));
        Project saved = project.withPlans(project.plans().stream()
                .map(p -> p.id().equals(plan.id()) ? kept : p)
                .toList());
        assertThat(new ProjectWriter(LIBRARY.vocabulary()).text(saved)).contains("gets stuck");
    }
}
