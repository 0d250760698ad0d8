package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;

/** An abort at any moment leaves every boat stopped. */
@Tag("long")
class AbortTest {
    private static final int MOMENTS = 60;
    private static final long LATEST_MILLIS = 320_000;
    private static final long STOPPING_MILLIS = 8_000;

    @Test
    void abortAtAnyMomentLeavesEveryBoatStopped() {
        RunPlan plan = TestRuns.plan("clv");
        Random moments = new Random(20);

        for (int i = 0; i < MOMENTS; i++) {
            long at = 1_000 + (long) (moments.nextDouble() * LATEST_MILLIS);
            InProcessRun run =
                    new InProcessRun(plan, TestRuns.settings(plan, 3, 20, 3), AnswersFile.EMPTY, RunJournal.none());
            run.water().clock().at(at, () -> run.host().post(new Input.AbortMission(Ids.NONE)));

            RunReport report = run.run(Pacer.UNPACED, RunObserver.NONE);
            run.coast(STOPPING_MILLIS);

            assertThat(report.result().outcome()).as("aborted at %d ms", at).isEqualTo(RunOutcome.ABORTED);
            assertThat(run.water().boats())
                    .as("aborted at %d ms", at)
                    .allSatisfy(boat -> assertThat(Math.abs(boat.speedMps())).isLessThan(0.05));
        }
    }
}
