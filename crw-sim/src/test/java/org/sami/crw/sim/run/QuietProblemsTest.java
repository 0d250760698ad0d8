package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.ReportText;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.crw.sim.run.settings.RunPlan;

/** A run that ends although something could not be done names it and is not green. */
class QuietProblemsTest {
    private static RunReport run(String plan) {
        return ProblemRuns.run(plan, Map.of(), InitialCharges.FULL, "");
    }

    private static void assertProblem(RunReport report, String... words) {
        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.isGreen()).isFalse();
        assertThat(report.problems()).singleElement().satisfies(problem -> {
            assertThat(problem.message()).contains(words);
            assertThat(ReportText.text(report)).contains("problem             " + problem.message());
        });
    }

    @Test
    void boatThatNobodyKnowsIsNamed() {
        assertProblem(run("goto"), "ProxyGotoPoint failed", "boat9", "there is no boat of that name");
    }

    @Test
    void thresholdsThatMakeNoSenseAreNamed() {
        assertProblem(run("battery"), "BatteryLevelSubscription failed", "critical 20.0 and low 10.0");
    }

    @Test
    void sensorThatNoBoatHasIsNamed() {
        assertProblem(run("sensor"), "TakeMeasurement failed", "boat1 has not measured \"salt\"");
    }

    @Test
    void moreBoatsThanThereAreAreNotChosen() {
        RunPlan plan = TestRuns.plan("clv");
        RunReport report = new InProcessRun(
                        plan,
                        TestRuns.settings(plan, 2, 3, 1),
                        AnswersFileReader.read(
                                        "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": "
                                                + "[{\"event\": \"OperatorSelectBoatList\", \"answer\": {\"boats\": 5}}]}",
                                        TestRuns.LIBRARY.vocabulary())
                                .orThrow(),
                        RunJournal.none())
                .run(Pacer.UNPACED, RunObserver.NONE);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.FAILED);
        assertThat(report.problems())
                .extracting(NoteResult::message)
                .containsExactly("answers file, /rules/0/answer: 5 boats are wanted, and there are 2 to choose from");
    }
}
