package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.DecisionResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;

/**
 * A location that a boat reaches with a full battery only beyond the charge at which the battery turns critical: the operator is asked before
 * the third attempt, and the mission ends.
 */
class FutileReturnRunTest {
    private static final double RANGE_M = 1500;
    private static final double QUAY_M = 360; // south of the middle of a square of 600 m

    @Test
    void boatThatComesBackTwiceWithoutAVisitGoesWithoutComingHomeWhereItsChargeLasts() {
        RunReport report = run(700, "");

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(asked(report, "FutileWay"))
                .singleElement()
                .satisfies(question -> assertThat(question.prompt())
                        .startsWith("boat1 came back twice with a critical battery and had visited nothing more: ")
                        .endsWith(". Send it without coming home first?"));
        assertThat(report.locations()).allMatch(LocationResult::visited);
        assertThat(report.boats()).extracting(BoatResult::recharges).containsExactly(2);
        assertThat(report.notes())
                .anyMatch(
                        note -> note.message().endsWith("It goes on without coming home first, as the operator wants"));
    }

    @Test
    void boatIsLeftOutWhereTheOperatorDoesNotWantIt() {
        RunReport report = run(700, "{\"event\": \"FutileWay\", \"answer\": {\"yes\": false}}");

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.locations()).noneMatch(LocationResult::visited);
        assertThat(report.boats()).extracting(BoatResult::recharges).containsExactly(2);
        assertThat(report.notes())
                .anyMatch(note -> note.message().contains("the operator does not want it: boat1 came back twice"));
    }

    /** Nobody sends a boat by default to where it would have to be fetched. */
    @Test
    void boatThatWouldNotComeBackIsLeftOut() {
        RunReport report = run(800, "");

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(asked(report, "OneWay"))
                .singleElement()
                .satisfies(question -> assertThat(question.prompt()).contains("it would have to be fetched"));
        assertThat(report.locations()).noneMatch(LocationResult::visited);
    }

    private static List<DecisionResult> asked(RunReport report, String type) {
        return report.decisions().stream()
                .filter(decision -> decision.type().equals(type))
                .toList();
    }

    private static RunReport run(double farM, String rule) {
        double latDeg = 45.7 + (farM - QUAY_M) / 111_150.0;
        String location = "{\"event\": \"OperatorCreateLocations\", \"answer\": {\"values\": {\"locations\":"
                + " [{\"lat\": " + latDeg + ", \"lon\": 10.72}]}}}";
        String rules = "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": [" + location
                + (rule.isEmpty() ? "" : ", " + rule) + "]}";
        RunSettings settings = RunSettings.of(
                        "clv-interrupts", "Visits", new FleetSettings(1, 1, 600, 1).withRangeM(RANGE_M))
                .limitMillis(20_000_000)
                .answers(rules)
                .interrupts(List.of("recharge@battery"))
                .build();
        AnswersFile answers =
                AnswersFileReader.read(rules, TestRuns.LIBRARY.vocabulary()).orThrow();
        return new InProcessRun(TestRuns.plan("clv-interrupts"), settings, answers, RunJournal.none())
                .run(Pacer.UNPACED, RunObserver.NONE);
    }
}
