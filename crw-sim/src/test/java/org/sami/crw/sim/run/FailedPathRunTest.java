package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.report.FiringResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;

/** Plans of the library on boats whose paths fail, because the current is faster than they are: the plans say what is done then. */
class FailedPathRunTest {
    private static final Conditions TORRENT = new Conditions(0, 0, Flow.parse("5@90"), Flow.NONE, List.of());

    private static RunReport run(String id, Map<String, String> parameters, List<String> interrupts, String rules) {
        RunPlan plan = TestRuns.plan(id);
        String answers = "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": [" + rules + "]}";
        RunSettings settings = RunSettings.of(id, id, new FleetSettings(2, 4, 300, 1).on(TORRENT))
                .limitMillis(7_200_000)
                .parameters(parameters)
                .answers(answers)
                .interrupts(interrupts)
                .build();
        AnswersFile file =
                AnswersFileReader.read(answers, TestRuns.LIBRARY.vocabulary()).orThrow();
        return new InProcessRun(plan, settings, file, RunJournal.none()).run(Pacer.UNPACED, RunObserver.NONE);
    }

    private static List<String> fired(RunReport report) {
        return report.firings().stream().map(FiringResult::transition).toList();
    }

    private static String answer(int nth, boolean yes) {
        return "{\"event\": \"OperatorApproveBoats\", \"nth\": " + nth + ", \"answer\": {\"yes\": " + yes + "}}";
    }

    @ParameterizedTest
    @ValueSource(strings = {"clv", "clv-interrupts"})
    void boatsWhosePathsFailAreLeftOutAndTheMissionEnds(String plan) {
        RunReport report = run(plan, Map.of(), List.of(), "");

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(Collections.frequency(fired(report), "Path failed")).isEqualTo(2);
        assertThat(Collections.frequency(fired(report), "Left out")).isEqualTo(2);
        assertThat(fired(report)).endsWith("All paths completed");
    }

    @Test
    void theOperatorMayLetABoatTryAgainAndBringAnotherHome() {
        RunReport report = run(
                "clv",
                Map.of(),
                List.of(),
                String.join(",", answer(1, false), answer(2, false), answer(3, false), answer(4, true)));

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(fired(report)).contains("Try again", "Bring home", "Home chosen", "Home not reached", "Left out");
    }

    @Test
    void aBoatThatCannotReachItsStationIsLeftOutOfTheWatch() {
        RunReport report = run("station-keep", Map.of("watch-time.duration", "PT15M"), List.of(), "");

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(fired(report)).contains("Station not reached", "Left out");
    }

    @Test
    void boatsThatCannotAssembleWaitWhereTheyAreForTheEndOfTheAlarm() {
        RunReport report = run("clv-interrupts", Map.of(), List.of("alarm@60"), "");

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(fired(report)).contains("Not arrived", "Nobody has arrived", "Alarm over", "End alarm", "Left out");
    }

    @Test
    void boatsThatCannotReachTheRechargeStationComeBackWithoutASwap() {
        RunReport report = run("clv-interrupts", Map.of(), List.of("recharge:2@60"), "");

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(fired(report)).contains("Not arrived", "Nobody has arrived", "End recharge", "Left out");
    }
}
