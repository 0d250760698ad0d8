package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.operator.mission.Wait;
import org.sami.crw.operator.mission.Wait.BlockedTransition;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;

/** A run in which nothing can happen any longer ends and says why. */
class StuckRunTest {
    private static final Conditions WINDY = new Conditions(0, 0, Flow.parse("0.3@90"), Flow.parse("6@270"), List.of());

    @Test
    void missionThatNobodyAnswersFailsWithTheQuestion() {
        RunPlan plan = TestRuns.plan("clv");
        AnswersFile silent = AnswersFileReader.read(
                        "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": "
                                + "[{\"event\": \"OperatorCreateLocations\", \"answer\": {\"silent\": true}}]}",
                        TestRuns.LIBRARY.vocabulary())
                .orThrow();

        RunReport report = new InProcessRun(plan, TestRuns.settings(plan, 2, 3, 1), silent, RunJournal.none())
                .run(Pacer.UNPACED, RunObserver.NONE);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.FAILED);
        assertThat(report.result().reason()).startsWith("nobody answers: ");
        assertThat(report.result().simulatedMillis()).isLessThan(60_000);
    }

    @Test
    void missionThatWantsNothingOfItsBoatsIsStuckAtOnceThoughTheyDrift() {
        RunReport report = run("drifting", WINDY);

        long lastFiring = report.firings().get(0).atMillis();
        assertThat(report.result().outcome()).isEqualTo(RunOutcome.FAILED);
        assertThat(report.result().reason()).isEqualTo("nothing can happen in the mission any longer");
        assertThat(report.result().simulatedMillis()).isBetween(lastFiring, lastFiring + 15_000);
    }

    @Test
    void answeredQuestionIsNotWaitedForAndWhatIsMissingIsNamed() {
        assertThat(run("drifting", Conditions.CALM).waits())
                .containsExactly(
                        new Wait(
                                1,
                                "drifting",
                                "Go there",
                                List.of("generic"),
                                "other tokens: It waits for Proxy Path Completed, which can come no longer: "
                                        + "those that 'Go there' asked are there no longer.",
                                List.of(new BlockedTransition(
                                        "There",
                                        List.of("It waits for Proxy Path Completed, which can come no longer: "
                                                + "those that 'Go there' asked are there no longer.")))),
                        new Wait(
                                1,
                                "drifting",
                                "Asked",
                                List.of("boat1"),
                                "other tokens: 'Gate' must have at least 1 generic tokens; there are 0. "
                                        + "It waits for No Option, which can come no longer: what 'Asked' asked has been answered.",
                                List.of(
                                        new BlockedTransition(
                                                "Yes",
                                                List.of("'Gate' must have at least 1 generic tokens; there are 0.")),
                                        new BlockedTransition(
                                                "No",
                                                List.of("It waits for No Option, which can come no longer: "
                                                        + "what 'Asked' asked has been answered.")))));
    }

    @Test
    void subMissionThatHasEndedIsNotWaitedFor() {
        Wait wait = run("helped", Conditions.CALM).waits().get(0);

        assertThat(wait.place()).isEqualTo("Help");
        assertThat(wait.occurrence())
                .isEqualTo("other tokens: It waits for Check Return 'good', which can come no longer: "
                        + "the sub-mission on 'Help' is over.");
    }

    @Test
    void sharedSubMissionThatHasReturnedTheBoatIsNotWaitedFor() {
        assertThat(run("returned", Conditions.CALM).waits())
                .extracting(Wait::plan, Wait::place, Wait::occurrence)
                .containsExactly(tuple(
                        "returned", "Help", "other tokens: 'Gate' must have at least 1 generic tokens; there are 0."));
    }

    private static RunReport run(String id, Conditions water) {
        Project project = new ProjectReader(TestRuns.LIBRARY.vocabulary())
                .read(TestRuns.text("stuck-project.json"))
                .orThrow();
        RunPlan plan = new RunPlan(
                TestRuns.LIBRARY.vocabulary(), project, project.plan(id).orElseThrow());
        RunSettings settings = TestRuns.settings(plan, 1, 3, 1);
        return TestRuns.run(plan, settings.withFleet(settings.fleet().on(water)));
    }
}
