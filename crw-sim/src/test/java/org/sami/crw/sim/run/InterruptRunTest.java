package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.crw.report.DecisionResult;
import org.sami.crw.report.InterruptResult;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.ReportText;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;

/** Interrupts pressed in a run. */
class InterruptRunTest {
    @Test
    void buttonOfAPlanIsPressedAtItsTime() {
        RunReport report = run("station-keep", "End station keeping@100");

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        InterruptResult pressed = report.interrupts().get(0);
        assertThat(pressed.taken()).isTrue();
        assertThat(pressed.takenAtMillis().getAsLong()).isBetween(100_000L, 101_000L);
        assertThat(report.result().simulatedMillis())
                .isEqualTo(pressed.takenAtMillis().getAsLong());
    }

    @Test
    void interruptThatComesTooEarlyIsPressedAgainUntilItIsTaken() {
        RunReport report = run("station-keep", "End station keeping@0");

        InterruptResult pressed = report.interrupts().get(0);
        assertThat(pressed.pressedAtMillis().getAsLong()).isLessThan(1_000);
        assertThat(pressed.presses()).isGreaterThan(1);
        assertThat(pressed.takenAtMillis().getAsLong()).isGreaterThan(5_000);
        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
    }

    @Test
    void interruptWhoseTimeComesAfterTheEndIsReportedAsNotPressed() {
        RunReport report = run("station-keep", "End station keeping@5000");

        assertThat(report.result().simulatedMillis()).isLessThan(5_000_000);
        assertThat(report.interrupts())
                .containsExactly(new InterruptResult(
                        "End station keeping",
                        "",
                        InterruptResult.TIME,
                        OptionalLong.empty(),
                        OptionalLong.empty(),
                        0));
    }

    @Test
    void boatThatTurnsCriticalDuringAnAlarmIsRechargedAtOnce() {
        RunPlan plan = TestRuns.plan("clv-interrupts");
        RunSettings settings = TestRuns.settings(plan, 3, 12, 1);
        RunReport report = TestRuns.run(
                plan,
                settings.withFleet(settings.fleet().with(InitialCharges.parse("100,37,100")))
                        .withInterrupts(List.of("recharge@battery", "alarm@120")));

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.interrupts()).allSatisfy(pressed -> {
            assertThat(pressed.taken()).isTrue();
            assertThat(pressed.presses()).isEqualTo(1);
        });
        assertThat(ReportText.text(report)).doesNotContain("refused", "discarded");
    }

    @Test
    void refusedPressSaysWhereTheBoatIs() {
        RunReport report = run("clv-interrupts", "recharge:2@60", "recharge:2@70");

        assertThat(report.notes())
                .extracting(NoteResult::message)
                .contains("Nobody is there for the interrupt 'recharge'; boat2 is in 'Recharge'");
    }

    @Test
    void runInWhichAllWentRightTellsOfNothingThatWasDiscarded() {
        for (String plan : List.of("clv", "station-keep", "measure", "explore-area")) {
            RunPlan runPlan = TestRuns.plan(plan);
            RunReport report = TestRuns.run(
                    runPlan, TestRuns.settings(runPlan, 3, 6, 7).withFleet(new FleetSettings(3, 6, 400, 7)));
            assertThat(ReportText.text(report)).as(plan).contains("ended").doesNotContain("discarded");
            assertThat(report.isGreen()).as(plan).isTrue();
            assertThat(report.decisions())
                    .as(plan)
                    .extracting(DecisionResult::type)
                    .doesNotContain("DoubtfulWay", "LongWay");
        }
    }

    private static RunReport run(String plan, String... interrupts) {
        RunPlan runPlan = TestRuns.plan(plan);
        return TestRuns.run(runPlan, TestRuns.settings(runPlan, 3, 6, 7).withInterrupts(List.of(interrupts)));
    }
}
