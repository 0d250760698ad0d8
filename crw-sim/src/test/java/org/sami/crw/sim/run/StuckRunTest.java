package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.sim.report.RunOutcome;
import org.sami.crw.sim.report.RunReport;

/** A run in which nothing can happen any longer ends and says why. */
class StuckRunTest {
    @Test
    void missionThatNobodyAnswersFailsWithTheQuestion() {
        RunPlan plan = Runs.plan("clv");
        AnswersFile silent = AnswersFileReader.read(
                        "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": "
                                + "[{\"event\": \"OperatorCreateLocations\", \"answer\": {\"silent\": true}}]}",
                        Runs.LIBRARY.vocabulary())
                .orThrow();

        RunReport report = new InProcessRun(plan, Runs.settings(plan, 2, 3, 1), silent, RunJournal.none())
                .run(Pacer.UNPACED, RunObserver.NONE);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.FAILED);
        assertThat(report.result().reason()).startsWith("nobody answers: ");
        assertThat(report.result().simulatedMillis()).isLessThan(400_000);
    }
}
