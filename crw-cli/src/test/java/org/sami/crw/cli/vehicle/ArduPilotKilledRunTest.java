package org.sami.crw.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.SimulatorTruth;

/**
 * As {@link KilledRunOfAVehicleTest}, with the real firmware, which holds a third of the path: with {@code -PvehicleMissions}, as it takes minutes.
 */
@Tag("long")
@Timeout(1800)
class ArduPilotKilledRunTest {
    private static final int NUMBER = 78;
    private static final int SPEED = 10;
    private static final int LOCATIONS = 2_000;
    private static final int LANE = 40; // locations
    private static final double WAIT_S = 1500;
    private static final double RADIUS_M = 3;
    private static final LocalFrame START = new LocalFrame(45.7, 10.72 + 0.0003 * NUMBER);

    @TempDir
    private Path folder;

    @Test
    void visitsEachLocationOfAPathThatIsSentInPartsOverTheDeathOfTheBase() throws Exception {
        assumeTrue(Boolean.getBoolean("crw.vehicleMissions"), "minutes on real firmware: only with -PvehicleMissions");
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        Path journal = folder.resolve("journal");
        try (RunProcesses runs = new RunProcesses(folder, LOCATIONS);
                ArduPilotBoats boats = new ArduPilotBoats(NUMBER, 1, SPEED, folder);
                SimulatorTruth truth = truth()) {
            Process first = runs.crw(
                    "first",
                    "run",
                    "clv",
                    "--connect",
                    ArduPilotBoats.address(NUMBER) + "/" + (NUMBER + 1),
                    "--connect-within",
                    "300",
                    "--answers",
                    answers().toString(),
                    "--answer-after",
                    "0.2",
                    "--journal",
                    journal.toString());
            until(runs, "first", 10);
            until(runs, "first", LOCATIONS * 9 / 20);
            first.destroyForcibly().waitFor();
            int killed = truth.samples();
            Await.until("it drives on by itself for half a minute", WAIT_S, () -> truth.samples() > killed + 300);

            Process second = runs.crw("second", "resume", journal.toString());
            until(runs, "second", LOCATIONS - 40);
            assertThat(second.waitFor()).as(runs.saidBy("second")).isZero();

            double greatestM = places().stream()
                    .mapToDouble(place -> truth.nearestM(place[0], place[1]))
                    .max()
                    .orElseThrow();
            System.out.printf(Locale.ROOT, "%d locations: at most %.2f m away%n", LOCATIONS, greatestM);
            assertThat(greatestM).isLessThan(RADIUS_M);
        }
    }

    private static void until(RunProcesses runs, String name, int visited) {
        Await.until(visited + " locations are visited", WAIT_S, () -> runs.visitedBy(name) >= visited);
    }

    /** The port opens a moment after the start. */
    private static SimulatorTruth truth() {
        List<SimulatorTruth> open = new ArrayList<>();
        Await.until("the boat listens", () -> {
            try {
                return open.add(new SimulatorTruth(ArduPilotBoats.secondPort(NUMBER), NUMBER + 1));
            } catch (IOException notYet) {
                return false;
            }
        });
        return open.get(0);
    }

    /** Lanes to and fro, 8 m apart, with a location every 3 m: latitude and longitude in degrees. */
    private static List<double[]> places() {
        return IntStream.range(0, LOCATIONS)
                .mapToObj(i -> {
                    int lane = i / LANE;
                    int along = lane % 2 == 0 ? i % LANE : LANE - 1 - i % LANE;
                    return new double[] {
                        START.latDeg(3.0 * along, 10 + 8.0 * lane), START.lonDeg(3.0 * along, 10 + 8.0 * lane)
                    };
                })
                .toList();
    }

    private Path answers() throws IOException {
        String places = places().stream()
                .map(at -> String.format(Locale.ROOT, "{\"lat\": %.7f, \"lon\": %.7f}", at[0], at[1]))
                .collect(Collectors.joining(", "));
        return Files.writeString(
                folder.resolve("answers.json"),
                "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": [{\"event\": \"OperatorCreateLocations\","
                        + " \"answer\": {\"values\": {\"locations\": [" + places + "]}}}]}");
    }
}
