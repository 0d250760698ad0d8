package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.crw.report.FiringResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TrackPoint;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.testcase.TestCaseRunner;
import org.sami.uav.handler.UavRuns.Run;

/** Every plan of the aircraft's library, from its start to its end on simulated copters. */
class CopterPlansRunTest {
    private static final String POST = "45.7005,10.7205";

    private static Arguments of(Run run, String... fires) {
        return Arguments.of(run, Arrays.asList(fires));
    }

    private static Stream<Arguments> runs() {
        return Stream.of(
                of(Run.of("first-flight", 2), "Airborne", "Time is up", "All are down"),
                of(Run.of("first-flight", 2).charged("35.3"), "Battery low in the climb", "All are down"),
                of(Run.of("look", 1), "There", "Seen", "All down"),
                of(
                        Run.of("look", 1)
                                .charged("38.8")
                                .with(Map.of("fly-to.location", "{\"lat\": 45.7, \"lon\": 10.72, \"alt\": 30}")),
                        "There",
                        "Battery low at the location",
                        "All down"),
                of(
                        Run.of("look", 1)
                                .with(Map.of("fly-to.location", "{\"lat\": 45.7, \"lon\": 10.72, \"alt\": 300}")),
                        "Not there",
                        "All down"),
                of(Run.of("search", 2), "Arrived", "All searched", "All are down"),
                of( // nobody flies so high, and the simulated operator has it allocated anew each time
                        Run.of("search", 2)
                                .answering("{\"event\": \"CreateLocations\", \"answer\": {\"values\": {\"locations\": ["
                                        + "{\"lat\": 45.7, \"lon\": 10.72, \"alt\": 300},"
                                        + "{\"lat\": 45.7, \"lon\": 10.72}]}}}"),
                        "Cannot fly there",
                        "Allocate anew",
                        "No aircraft can",
                        "All searched",
                        "All are down"),
                of(
                        Run.of("search", 2).charged("37"),
                        "Battery low",
                        "Lost under way",
                        "Battery is charged",
                        "All searched",
                        "All are down"),
                of(Run.of("path-approval", 2).charged("37"), "Battery low", "All are down"),
                of(
                        Run.of("path-approval", 2)
                                .answering("{\"event\": \"ApprovePaths\", \"nth\": 1, \"answer\": {\"yes\": false}}"),
                        "Not approved",
                        "Approved",
                        "Path flown",
                        "All are down"),
                of(Run.of("search-area", 2), "Target sighted", "Lanes flown", "All are down"),
                of(Run.of("search-area", 2).in(NamedConditions.ROUGH).with(Map.of("limit", "2")), "Wind too strong"),
                of(Run.of("search-area", 2).charged("36"), "Battery low", "All are down"),
                of(Run.of("two-look-closer", 3), "Target sighted", "There", "Pictures taken", "It is one"),
                of(
                        Run.of("two-look-closer", 3).charged("40,40,100"),
                        "Battery low of one that stands by",
                        "Battery is charged",
                        "All are down"),
                of(
                        Run.of("battery-rotation", 3)
                                .charged("45")
                                .with(Map.of("location", POST, "watch-time.duration", "600s")),
                        "Battery low",
                        "The next one flies",
                        "Back in reserve",
                        "Time is up"),
                of(
                        Run.of("battery-rotation", 3)
                                .charged("45,45,100")
                                .with(Map.of("location", "45.716,10.72", "watch-time.duration", "600s"))
                                .answering("{\"event\": \"LongWay\", \"answer\": {\"yes\": false}}"),
                        "Cannot fly there",
                        "The next one flies",
                        "Stays out",
                        "At the post",
                        "Time is up"),
                of( // nobody flies so high
                        Run.of("battery-rotation", 2)
                                .with(Map.of(
                                        "location",
                                        "{\"lat\": 45.7005, \"lon\": 10.7205, \"alt\": 300}",
                                        "watch-time.duration",
                                        "120s")),
                        "Cannot fly there",
                        "The next one flies",
                        "None is left",
                        "Time is up",
                        "All are down"),
                of(
                        Run.of("battery-rotation", 2)
                                .charged("35.5,100")
                                .with(Map.of("location", POST, "watch-time.duration", "120s")),
                        "Battery low on the way",
                        "The next one flies",
                        "At the post",
                        "Back in reserve",
                        "Time is up"),
                of(Run.of("follow", 2).charged("35.3"), "Battery low in the climb", "All are down"),
                of(
                        Run.of("follow", 2)
                                .with(Map.of("robot", "copter1", "how-long.duration", "60s"))
                                .answering("{\"event\": \"ChooseAircraft\", \"answer\": {\"boats\": [\"copter2\"]}}"),
                        "Airborne",
                        "Time is up",
                        "All are down"),
                of(Run.of("follow", 2), "Airborne", "Time is up", "All are down"),
                of(Run.of("follow", 2).charged("37"), "Battery low", "All are down"),
                of(
                        Run.of("wind-watch", 1).with(Map.of("location", POST, "how-long.duration", "20s")),
                        "There",
                        "Time is up"),
                of(
                        Run.of("wind-watch", 1)
                                .in(NamedConditions.ROUGH)
                                .with(Map.of("location", POST, "wind.limit", "2")),
                        "Wind too strong"));
    }

    @ParameterizedTest
    @MethodSource("runs")
    void runsToItsEnd(Run run, List<String> fires) {
        RunReport report = run.report();

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.firings().stream().map(FiringResult::transition)).containsAll(fires);
        assertThat(report.boats()).allMatch(copter -> copter.batteryPercent() > 0);
    }

    /** They fly to one place, each at an altitude of its own. */
    @Test
    void copterComesNoNearerToAnotherThanTheirAltitudesLie() {
        RunReport report = Run.of("look", 4)
                .with(Map.of("fly-to.location", "{\"lat\": 45.7, \"lon\": 10.72}"))
                .report();

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.map().closest().near()).allMatch(pair -> pair.distanceM() > 3);
    }

    @Test
    void trueTracksHaveTheHeightsAtWhichCoptersFlyInLayers() {
        RunReport report = Run.of("wind-watch", 3)
                .with(Map.of("location", POST, "how-long.duration", "20s"))
                .report();

        List<Double> highestM = report.boats().stream()
                .map(boat -> boat.track().stream()
                        .mapToDouble(TrackPoint::altM)
                        .max()
                        .orElse(0))
                .sorted()
                .toList();
        assertThat(highestM.get(0)).isGreaterThan(10);
        assertThat(highestM.get(1) - highestM.get(0)).isBetween(3.0, 5.0);
        assertThat(highestM.get(2) - highestM.get(1)).isBetween(3.0, 5.0);
        assertThat(report.map().closest().ever())
                .hasValueSatisfying(near -> assertThat(near.distanceM()).isGreaterThan(2));
    }

    @Test
    void plansHaveNoFindingsAndGoAsTheirTestCasesExpect() {
        UavRuns.DOMAIN.projects().values().forEach(project -> {
            assertThat(PlanChecks.check(project, UavRuns.DOMAIN.vocabulary())).isEmpty();
            assertThat(new TestCaseRunner(project, UavRuns.DOMAIN.vocabulary()).runAll())
                    .isEmpty();
            assertThat(project.plans())
                    .allMatch(plan -> !plan.testCases().isEmpty())
                    .allMatch(plan -> !plan.layout().isEmpty());
        });
        assertThat(UavRuns.DOMAIN.plans()).hasSizeGreaterThanOrEqualTo(8);
    }
}
