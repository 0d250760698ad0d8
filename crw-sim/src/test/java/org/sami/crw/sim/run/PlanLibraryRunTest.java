package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.report.Exploration;
import org.sami.crw.report.FiringResult;
import org.sami.crw.report.InterruptResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;

/** Plans of the library from their start to their end, with the simulated operator, in calm, field and rough water. */
@Tag("long")
class PlanLibraryRunTest {
    private static final String NO_LOCATIONS =
            "{\"event\": \"OperatorCreateLocations\", \"answer\": {\"values\": {\"locations\": []}}}";

    /**
     * One run.
     *
     * @param fires names of transitions that fire in it, in any order
     */
    private record Run(
            String plan,
            NamedConditions water,
            FleetSettings fleet,
            Map<String, String> values,
            List<String> interrupts,
            String answers,
            List<String> fires) {
        static Run of(String plan, int boats, int locations, double areaM, String... fires) {
            FleetSettings fleet = new FleetSettings(boats, locations, areaM, 3);
            return new Run(plan, NamedConditions.CALM, fleet, Map.of(), List.of(), "", List.of(fires));
        }

        Run with(Map<String, String> newValues) {
            return new Run(plan, water, fleet, newValues, interrupts, answers, fires);
        }

        Run pressing(String... newInterrupts) {
            return new Run(plan, water, fleet, values, List.of(newInterrupts), answers, fires);
        }

        Run answering(String rules) {
            return new Run(plan, water, fleet, values, interrupts, rules, fires);
        }

        Run on(NamedConditions other) {
            return new Run(plan, other, fleet.on(other.conditions()), values, interrupts, answers, fires);
        }

        RunReport report() {
            RunPlan runPlan = TestRuns.plan(plan);
            String text = "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": [" + answers + "]}";
            RunSettings settings = RunSettings.of(plan, plan, fleet)
                    .limitMillis(7_200_000)
                    .parameters(values)
                    .answers(text)
                    .interrupts(interrupts)
                    .build();
            AnswersFile file =
                    AnswersFileReader.read(text, TestRuns.LIBRARY.vocabulary()).orThrow();
            return new InProcessRun(runPlan, settings, file, RunJournal.none()).run(Pacer.UNPACED, RunObserver.NONE);
        }

        @Override
        public String toString() {
            return plan + ", " + water + " " + interrupts;
        }
    }

    private static String no(String event, String plan, int nth) {
        return "{\"event\": \"%s\", \"plan\": \"%s\", \"nth\": %d, \"answer\": {\"yes\": false}}"
                .formatted(event, plan, nth);
    }

    private static List<Run> plans() {
        return List.of(
                Run.of("clv", 3, 9, 200, "Path completed", "All paths completed"),
                Run.of("clv-interrupts", 3, 9, 200, "Start alarm", "End alarm", "Start recharge during an alarm")
                        .pressing("alarm@30", "recharge:2@60"),
                Run.of("measure", 2, 5, 150, "Task completed", "All tasks finished"),
                Run.of("station-keep", 2, 1, 150, "Arrived", "Still near", "Watch over", "End confirmed"),
                Run.of("explore-area", 3, 1, 200, "Somebody passes", "Clear again", "All explored")
                        .pressing("Let somebody pass@60"),
                Run.of("connect-boat", 1, 1, 200, "Boat chosen", "Connected", "Gains set"),
                Run.of("connect-boat-by-address", 1, 1, 200, "Connected", "Gains set")
                        .with(Map.of("call.name", "dora", "call.server", "192.168.1.104:11411")),
                Run.of("add-simulated-boats", 1, 1, 200, "Created", "Described")
                        .with(Map.of("make.numberToCreate", "3")),
                Run.of("disconnect-boats", 2, 1, 200, "Boats chosen", "Done"),
                Run.of("reconnect-boats", 2, 1, 200, "Boats chosen", "Done"),
                Run.of("resend-waypoints", 2, 1, 200, "At the end of its way", "All have answered"),
                Run.of("describe-boats", 2, 1, 200, "Boats chosen", "Done"),
                Run.of("explore-team", 3, 1, 200, "Share explored", "All explored"),
                Run.of(
                                "explore-team",
                                3,
                                1,
                                250,
                                "Another vessel comes",
                                "New place chosen",
                                "Not yet",
                                "It has passed",
                                "Start swap",
                                "Battery swapped",
                                "Abort boat",
                                "All explored")
                        .pressing(
                                "team avoid boat@60",
                                "move the safe place@63",
                                "battery swap:1@180",
                                "proxy abort:3@190")
                        .answering(
                                no("OperatorApprove", "avoid-boat", 1) + ", " + no("OperatorApprove", "avoid-boat", 2)),
                Run.of("communications-monitoring", 2, 1, 200, "Heard", "Rested", "Adjusted", "End monitoring")
                        .pressing("adjust timers@20", "end monitoring@90"),
                Run.of("communications-monitoring", 2, 1, 200, "Silent", "Out of reach", "Send again", "Home")
                        .with(Map.of(
                                "@lookEvery", "2050ms",
                                "@warnAfter", "5ms",
                                "@criticalAfter", "5ms",
                                "@homeAfter", "5ms",
                                "@resendEvery", "10s"))
                        .answering("""
                            {"event": "RedefineVariables", "answer": {"values": {"@home": {"lat": 45.6992, "lon": 10.72}}}}\
                            """)
                        .pressing("end monitoring@90"),
                Run.of("deploy-and-station-keep", 3, 1, 100, "Boat chosen", "One more", "Place found", "No more")
                        .answering(no("OperatorApprove", "deploy-and-station-keep", 2)),
                Run.of("deploy-and-station-keep", 2, 1, 100, "New places found", "Near", "Ended by button")
                        .pressing("move the station@90", "end station keeping@200"),
                Run.of("radio-measurement", 3, 1, 100, "Blue there", "Red there", "Both there", "Collected"),
                Run.of("clv-dangerous-area", 2, 4, 150, "Goes in", "Path completed there")
                        .pressing("traverse dangerous area@60"),
                Run.of("clv-reassign", 3, 9, 200, "Start recharge", "Share it out", "Recharged", "Division accepted")
                        .pressing("recharge:2@60"),
                Run.of("panorama", 2, 5, 150, "Picture taken", "Task completed", "All tasks finished"),
                Run.of("look-around", 2, 1, 100, "Pictures taken", "Target", "All are looked at"),
                Run.of("panorama-together", 2, 5, 150, "All are ready", "Picture taken", "All tasks finished"),
                Run.of("panorama", 2, 1, 150, "No location").answering(NO_LOCATIONS),
                Run.of("panorama-together", 2, 1, 150, "No location").answering(NO_LOCATIONS),
                Run.of("explore-generic", 3, 1, 150, "A vessel comes", "In safety", "It has passed", "All explored")
                        .pressing("hazard@60"),
                Run.of("explore-marked", 3, 1, 150, "A vessel comes", "In safety", "It has passed", "All explored")
                        .pressing("hazard@60"),
                Run.of("bring-home", 3, 1, 150, "Boats chosen", "Places found", "Arrived", "All at home"),
                Run.of("bring-home", 3, 1, 150, "Boats chosen", "Places found", "Arrived", "All at home")
                        .answering("""
                            {"event": "OperatorSelectBoatList", "answer": {"silent": true}}\
                            """),
                Run.of("recharge-boats", 3, 1, 150, "Boats chosen", "Arrived", "All are there", "Batteries swapped"),
                Run.of("leave-area", 3, 1, 200, "Area drawn", "Boats chosen", "Out of the area", "All are out")
                        .answering("""
                            {"event": "OperatorCreateArea", "answer": {"values": {"area": {"outline": [
                            {"lat": 45.6988, "lon": 10.71985}, {"lat": 45.6988, "lon": 10.72015},
                            {"lat": 45.69905, "lon": 10.72015}, {"lat": 45.69905, "lon": 10.71985}]}}}}\
                            """),
                Run.of("background-actions", 1, 1, 150, "All begin", "Done", "Enough")
                        .pressing("end background actions@200"));
    }

    static Stream<Run> runs() {
        return Stream.of(NamedConditions.CALM, NamedConditions.FIELD, NamedConditions.ROUGH)
                .flatMap(water -> plans().stream().map(run -> run.on(water)));
    }

    /** Thesis 8.2: with markup made for each event boats come to safety in about half the time, and the mission ends earlier. */
    @Test
    void markupMakesTheWayToSafetyShorterInTime() {
        List<Double> seconds = new ArrayList<>();
        List<Long> missions = new ArrayList<>();
        for (String plan : List.of("explore-generic", "explore-marked")) {
            RunReport report = Run.of(plan, 3, 1, 200)
                    .pressing("hazard@120")
                    .answering("""
                        {"event": "RedefineVariables", "answer": {"values": {"@safePlace": {"lat": 45.7, "lon": 10.72}}}}\
                        """)
                    .report();
            seconds.add(atSeconds(report, "In safety") - atSeconds(report, "A vessel comes"));
            missions.add(report.result().simulatedMillis());
        }

        assertThat(seconds.get(1)).isLessThan(0.7 * seconds.get(0));
        assertThat(missions.get(1)).isLessThan(missions.get(0));
    }

    /** Boats that are called to safety in the middle of a lane drive that lane again. */
    @Test
    void nothingStaysUnexploredAfterAnInterrupt() {
        RunReport report = Run.of("explore-generic", 3, 1, 200)
                .pressing("hazard@120")
                .answering("""
                    {"event": "RedefineVariables", "answer": {"values": {"@safePlace": {"lat": 45.7, "lon": 10.72}}}}\
                    """)
                .report();

        assertThat(report.map().explorations()).hasSize(1);
        Exploration explored = report.map().explorations().get(0);
        assertThat(explored.percent(explored.uncoveredM2())).isGreaterThan(99.5);
    }

    private static double atSeconds(RunReport report, String transition) {
        return report.firings().stream()
                .filter(firing -> firing.transition().equals(transition))
                .mapToDouble(firing -> firing.atMillis() / 1000.0)
                .findFirst()
                .orElseThrow();
    }

    @ParameterizedTest
    @MethodSource("runs")
    void comesToItsEnd(Run run) {
        RunReport report = run.report();

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.isGreen()).as("problems: %s", report.notes()).isTrue();
        assertThat(report.firings()).extracting(FiringResult::transition).containsAll(run.fires);
        assertThat(report.interrupts()).allMatch(InterruptResult::taken);
    }
}
