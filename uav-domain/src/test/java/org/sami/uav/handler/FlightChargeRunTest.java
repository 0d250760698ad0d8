package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.crw.report.DecisionResult;
import org.sami.crw.report.FiringResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.uav.handler.UavRuns.Run;

/** Runs in which a copter is sent on a flight for which its charge does not last, with the simulated operator. */
class FlightChargeRunTest {
    private static final Run FAR = Run.of("look", 1)
            .with(Map.of("fly-to.location", "{\"lat\": 45.72, \"lon\": 10.72, \"alt\": 30}")); // 2.2 km

    private static List<DecisionResult> questions(RunReport report) {
        return report.decisions().stream()
                .filter(decision -> decision.type().equals("LongWay"))
                .toList();
    }

    private static List<String> fired(RunReport report) {
        return report.firings().stream().map(FiringResult::transition).toList();
    }

    @Test
    void operatorIsAskedOnceAndSendsIt() {
        RunReport report = FAR.charged("50").report();

        assertThat(questions(report))
                .singleElement()
                .satisfies(question -> assertThat(question.prompt())
                        .startsWith("copter1 needs ")
                        .contains("its charge of 50 % lasts 4", "25 minutes")
                        .endsWith("Send it?"));
        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(fired(report)).contains("Battery low", "All down");
        assertThat(report.boats()).allMatch(copter -> copter.batteryPercent() > 0);
    }

    @Test
    void copterThatIsNotSentIsNotThere() {
        RunReport report = FAR.charged("50")
                .answering("{\"event\": \"LongWay\", \"answer\": {\"yes\": false}}")
                .report();

        assertThat(questions(report)).hasSize(1);
        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(fired(report)).contains("Not there", "All down");
        assertThat(report.boats()).allMatch(copter -> copter.batteryPercent() > 49);
    }

    /** All turn low within a moment: tasks of the first are allocated to the others, which are on their way home by the time the operator accepts. */
    @Test
    void copterThatIsOnItsWayHomeForABatteryGetsItBeforeItSearchesOn() {
        RunReport report = Run.of("search", 3).charged("36").report();

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.boats()).allMatch(copter -> copter.batteryPercent() > 20);
        assertThat(report.boats()).anyMatch(copter -> copter.recharges() > 0);
        assertThat(questions(report)).isEmpty();
    }

    /** Its flight is replaced by the one home, which its own plan wants. */
    @Test
    void copterThatAPlanCallsHomeIsNotReportedAsOneThatFailed() {
        RunReport report = Run.of("look", 2)
                .with(Map.of("fly-to.location", "{\"lat\": 45.707, \"lon\": 10.72, \"alt\": 30}"))
                .charged("40,100")
                .report();

        assertThat(fired(report)).contains("Battery low", "There", "All down");
        assertThat(report.notes()).noneMatch(note -> note.message().contains("could not do what"));
    }

    /** Two places 2 km and 2.6 km away: after the first, the charge lasts for the way home and not for the second. */
    @Test
    void copterInTheAirComesHomeWhereNobodyAnswersAndItsTaskIsFlownAfterwards() {
        RunReport report = Run.of("search", 1)
                .charged("66")
                .answering("{\"event\": \"LongWay\", \"answer\": {\"silent\": true}},"
                        + "{\"event\": \"CreateLocations\", \"answer\": {\"values\": {\"locations\": ["
                        + "{\"lat\": 45.716, \"lon\": 10.72}, {\"lat\": 45.7214, \"lon\": 10.72}]}}}")
                .report();

        assertThat(questions(report)).singleElement().satisfies(question -> {
            assertThat(question.prompt()).contains("Without an answer it comes home after ");
            assertThat(question.by()).isEqualTo("autonomy");
        });
        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.notes())
                .anyMatch(note -> note.message().contains("nobody has answered in time, and it comes home"));
        assertThat(report.boats()).allMatch(copter -> copter.recharges() == 1);
    }

    @Test
    void nobodyIsAskedWhereTheChargeLasts() {
        RunReport report = FAR.charged("100").report();

        assertThat(questions(report)).isEmpty();
        assertThat(fired(report)).contains("There", "Seen", "All down");
    }
}
