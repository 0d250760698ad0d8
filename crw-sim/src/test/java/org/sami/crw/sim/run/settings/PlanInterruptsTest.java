package org.sami.crw.sim.run.settings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.sim.run.TestRuns;

/** What a user may say after {@code --interrupt}. */
class PlanInterruptsTest {
    private static final List<String> BOATS = List.of("boat1", "boat2", "7");

    private static final RunPlan PLAN = TestRuns.plan("station-keep");

    @Test
    void namesInterruptsOfThePlan() {
        assertThat(interrupts("station-keep").names()).containsExactly("End station keeping");
        assertThat(interrupts("clv").names()).isEmpty();
    }

    @Test
    void timeIsReadInMilliseconds() {
        assertThat(interrupts("station-keep").read(List.of("End station keeping@12.5"), BOATS))
                .containsExactly(
                        new PlannedInterrupt("End station keeping", Optional.empty(), OptionalLong.of(12_500)));
    }

    @ParameterizedTest
    @CsvSource({
        "End station keeping,does not say when",
        "@5,does not say when",
        "End station keeping@,'' is no number of seconds",
        "End station keeping@soon,'soon' is no number of seconds",
        "End station keeping@-1,'-1' is no number of seconds",
        "End station keeping@NaN,'NaN' is no number of seconds",
        "stop@5,'no interrupt ''stop''; it has End station keeping'",
        "End station keeping:boat1@5,for the whole team",
        "End station keeping@battery,for the whole team",
    })
    void nonsenseIsRefusedWithItsReason(String text, String reason) {
        assertThatThrownBy(() -> interrupts("station-keep").read(List.of(text), BOATS))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'" + text + "'")
                .hasMessageContaining(reason.replace("''", "'"));
    }

    @Test
    void planWithoutInterruptsSaysSo() {
        assertThatThrownBy(() -> interrupts("clv").read(List.of("alarm@5"), BOATS))
                .hasMessageContaining("it has none");
    }

    private static PlanInterrupts interrupts(String plan) {
        RunPlan run = plan.equals("station-keep") ? PLAN : TestRuns.plan(plan);
        return new PlanInterrupts(run.vocabulary(), run.project(), run.plan());
    }
}
