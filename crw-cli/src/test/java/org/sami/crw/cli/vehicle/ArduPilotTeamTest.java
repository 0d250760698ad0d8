package org.sami.crw.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.sim.run.settings.Site;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.CameraDetector;
import org.sami.mavlink.testing.SimulatorTruth;
import org.sami.spn.value.GeoPoint;

/**
 * Plans of copters, and of copters and boats in one team, on the real firmware of both: the boats with a depth sounder of their simulator, the copters with a
 * detector on board, which speaks to the autopilot as a companion computer does. A no-go area
 * lies in their way. Where they truly were their simulators say.
 */
@Tag("long")
@Timeout(1200)
class ArduPilotTeamTest {
    private static final int BOATS = 64; // number of the first
    private static final int COPTERS = 66;
    private static final int EACH = 2;
    private static final int SPEED = 2;
    private static final double DEPTH_M = 8;
    private static final double SAMPLED_M = 3.5; // how near counts as there
    private static final double OVER_M = 3; // how near a copter flies
    /** The simulator's sounder is an analog one: it hangs 8 m above the bottom, as its water has none. */
    private static final String SOUNDER = "RNGFND1_TYPE 1\nRNGFND1_PIN 0\nRNGFND1_SCALING 12.12\nRNGFND1_ORIENT 25\n"
            + "RNGFND1_MIN 0\nRNGFND1_MAX 40\nSIM_SONAR_POS_Z -" + DEPTH_M + "\n";

    private static final LocalFrame WATER =
            new LocalFrame(45.7005, 10.72 + 0.0003 * (COPTERS - 0.5)); // 55 m north of them
    private static final List<double[]> TARGETS = List.of(place(-18, 12), place(20, -6));
    /** Within the area that is searched, between where the vehicles start and most of it. */
    private static final NoGoRectangle NO_GO = new NoGoRectangle(WATER, -30, -40, 2, -28);

    @TempDir
    private Path work;

    private final List<AutoCloseable> open = new ArrayList<>();

    @AfterEach
    void end() throws Exception {
        for (int i = open.size() - 1; i >= 0; i--) {
            open.get(i).close();
        }
    }

    private static double[] place(double eastM, double northM) {
        return new double[] {WATER.latDeg(eastM, northM), WATER.lonDeg(eastM, northM)};
    }

    private static GeoPoint middle() {
        double[] at = place(0, 0);
        return GeoPoint.of(at[0], at[1]);
    }

    /** Opens what may not listen yet. */
    @FunctionalInterface
    private interface Opening<T> {
        T open() throws IOException;
    }

    /** What listens a moment after the start. */
    private <T extends AutoCloseable> T opened(String what, Opening<T> opening) {
        List<T> made = new ArrayList<>();
        Await.until(what + " listens", () -> {
            try {
                return made.add(opening.open());
            } catch (IOException notYet) {
                return false;
            }
        });
        open.add(made.get(0));
        return made.get(0);
    }

    private List<SimulatorTruth> truths(int first) {
        return IntStream.range(first, first + EACH)
                .mapToObj(i ->
                        opened("vehicle " + (i + 1), () -> new SimulatorTruth(ArduPilotBoats.secondPort(i), i + 1)))
                .toList();
    }

    private List<CameraDetector> detectors(List<double[]> targets) {
        return IntStream.range(COPTERS, COPTERS + EACH)
                .mapToObj(i -> opened(
                        "copter " + (i + 1), () -> new CameraDetector(ArduPilotBoats.thirdPort(i), i + 1, targets)))
                .toList();
    }

    private static String addresses(int first, int count) {
        return IntStream.range(first, first + count)
                .mapToObj(i -> ArduPilotBoats.address(i) + "/" + (i + 1))
                .collect(Collectors.joining(","));
    }

    private CommandResult run(String domain, String plan, String addresses, String... more) throws IOException {
        List<String> arguments = new ArrayList<>(List.of(
                "run",
                NoGoRectangle.project(domain, plan, NO_GO.typed(), work).toString(),
                "--domain",
                domain,
                "--connect",
                addresses,
                "--connect-within",
                "300",
                "--at",
                Site.words(middle()),
                "--for",
                "900",
                "--answer-after",
                "1",
                "--report",
                work.resolve("report").toString()));
        arguments.addAll(List.of(more));
        CommandResult ran = CommandResult.crw(arguments.toArray(String[]::new));
        assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
        assertThat(ran.out()).contains("outcome             ended");
        return ran;
    }

    private List<String[]> rows(String table) throws IOException {
        return Files.readAllLines(work.resolve("report").resolve(table)).stream()
                .skip(1)
                .map(row -> row.split(",", -1))
                .toList();
    }

    /** None was within the no-go area, by what their simulators say. */
    private static void assertOutsideNoGo(List<SimulatorTruth> vehicles) {
        for (SimulatorTruth vehicle : vehicles) {
            assertThat(vehicle.gap())
                    .as("where it was is known for all of the time")
                    .isEmpty();
            List<double[]> places = vehicle.placesFrom(0);
            assertThat(NO_GO.inside(places))
                    .as("of " + places.size() + " reports")
                    .isZero();
        }
    }

    /** Whether the straight way to some place, from where some vehicle started, leads through the no-go area. */
    private static boolean liesInTheWay(List<SimulatorTruth> vehicles, List<double[]> places) {
        return vehicles.stream()
                .map(vehicle -> vehicle.placesFrom(0).get(0))
                .anyMatch(start -> places.stream().anyMatch(place -> NO_GO.isCutBy(start, place)));
    }

    private static double nearestM(List<SimulatorTruth> vehicles, double latDeg, double lonDeg) {
        return vehicles.stream()
                .mapToDouble(truth -> truth.nearestM(latDeg, lonDeg))
                .min()
                .orElseThrow();
    }

    @Test
    void boatsSampleWhatCoptersFindAndTheOperatorConfirms() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        open.add(ArduPilotBoats.with(SOUNDER, BOATS, EACH, SPEED, work));
        open.add(ArduPilotBoats.copters(COPTERS, EACH, SPEED, work));
        List<SimulatorTruth> boats = truths(BOATS);
        List<SimulatorTruth> copters = truths(COPTERS);
        List<CameraDetector> detectors = detectors(TARGETS);

        CommandResult ran = run(
                "team",
                "scout-and-sample",
                addresses(BOATS, 2 * EACH),
                "--area",
                "70",
                "--set",
                "@sensor=depth",
                "--set",
                "ask-lanes.spacing=20");

        assertThat(detectors.stream().mapToInt(CameraDetector::said).sum())
                .as("what cameras said")
                .isPositive();
        assertThat(ran.out()).contains("tasks: 2 of 2 complete");
        assertThat(TARGETS)
                .allSatisfy(target ->
                        assertThat(nearestM(boats, target[0], target[1])).isLessThan(SAMPLED_M));
        assertThat(liesInTheWay(boats, TARGETS)).isTrue();
        assertOutsideNoGo(boats);
        assertOutsideNoGo(copters);
        assertThat(depths().stream().map(row -> row[0]).distinct()).contains("mav" + (BOATS + 1), "mav" + (BOATS + 2));
        assertThat(depths())
                .allSatisfy(row -> assertThat(Double.parseDouble(row[5])).isCloseTo(DEPTH_M, within(0.1)));
    }

    private List<String[]> depths() throws IOException {
        return rows("readings.csv").stream()
                .filter(row -> row[3].equals("depth"))
                .toList();
    }

    @Test
    void coptersSearchEachLocationReportWhatTheySeeAndLand() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        open.add(ArduPilotBoats.copters(COPTERS, EACH, SPEED, work));
        List<SimulatorTruth> copters = truths(COPTERS);
        List<CameraDetector> detectors = detectors(TARGETS);

        CommandResult ran = run(
                "uav",
                "search",
                addresses(COPTERS, EACH),
                "--area",
                "70",
                "--locations",
                "3",
                "--set",
                "search-there.radius=30");

        assertThat(ran.out()).contains("tasks: 3 of 3 complete");
        assertThat(detectors.stream().mapToInt(CameraDetector::said).sum()).isPositive();
        assertThat(rows("decisions.csv")).anyMatch(row -> row[2].equals("ConfirmTarget"));
        assertThat(locations())
                .hasSize(3)
                .allSatisfy(at -> assertThat(nearestM(copters, at[0], at[1])).isLessThan(OVER_M));
        assertThat(liesInTheWay(copters, locations())).isTrue();
        assertOutsideNoGo(copters);
    }

    private List<double[]> locations() throws IOException {
        return rows("locations.csv").stream()
                .map(row -> new double[] {Double.parseDouble(row[1]), Double.parseDouble(row[2])})
                .toList();
    }
}
