package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.stepping.Stepper;

/** Plans that are run on by themselves, as by Run in DREAMM: robots, services and operator take turns until the mission ends. */
class RunsByThemselvesTest {
    static Stream<Arguments> runs() {
        return TriedPlans.library()
                .flatMap(of -> Stream.of(1, 3, 5)
                        .map(locations ->
                                Arguments.of(of.getValue().id() + " with " + locations + " locations", of, locations)));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("runs")
    void everyPlanOfTheLibraryRunsToItsEnd(String name, Map.Entry<Project, Plan> of, int locations) {
        Stepper stepper = TriedPlans.run(of.getKey(), of.getValue().id(), 3, locations);

        assertThat(stepper.outcome()).as(name).contains(Outcome.ENDED);
    }

    @ParameterizedTest
    @CsvSource({
        "T1-async, 1",
        "T1-async, 3",
        "T1-async, 5",
        "T5c-sync-right, 1",
        "T5c-sync-right, 3",
        "T5c-sync-right, 5"
    })
    void everyTaskOfAPanoramaIsFinished(String name, int locations) {
        Stepper stepper = TriedPlans.run(TriedPlans.panorama(name), "plan", 3, locations);

        assertThat(stepper.outcome()).contains(Outcome.ENDED);
        List<Effect> effects = stepper.steps().stream()
                .flatMap(step -> step.effects().stream())
                .toList();
        assertThat(fired(effects, "completed")).isEqualTo(locations);
        assertThat(fired(effects, "allfin")).isOne();
    }

    private static long fired(List<Effect> effects, String transition) {
        return effects.stream()
                .filter(effect -> effect instanceof Effect.Fired fired
                        && fired.transition().equals(transition))
                .count();
    }
}
