package org.sami.crw.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.CommandResult;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.SimulatorTruth;

/** A plan of the library on boats with the real firmware; with {@code -PvehicleMissions}, as it takes minutes. */
@Timeout(1200)
class ArduPilotMissionTest {
    private static final int FIRST = 84;
    private static final int BOATS = 3;
    private static final int SPEED = 5;
    private static final double RADIUS_M = 3;

    @TempDir
    private Path work;

    @Test
    void threeBoatsVisitEachLocationTrulyWithinTheRadius() throws Exception {
        assumeTrue(Boolean.getBoolean("crw.vehicleMissions"), "minutes on real firmware: only with -PvehicleMissions");
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        List<SimulatorTruth> truths = new ArrayList<>();
        try (ArduPilotBoats boats = new ArduPilotBoats(FIRST, BOATS, SPEED, work)) {
            for (int i = FIRST; i < FIRST + BOATS; i++) {
                truths.add(truth(i));
            }
            CommandResult ran = CommandResult.crw(
                    "run",
                    "clv",
                    "--connect",
                    IntStream.range(FIRST, FIRST + BOATS)
                            .mapToObj(ArduPilotBoats::address)
                            .collect(Collectors.joining(",")),
                    "--connect-within",
                    "300",
                    "--area",
                    "60",
                    "--locations",
                    "9",
                    "--report",
                    work.resolve("report").toString());

            assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
            List<String> locations = Files.readAllLines(work.resolve("report").resolve("locations.csv"));
            assertThat(locations).hasSize(10);
            assertThat(locations.subList(1, locations.size()))
                    .allSatisfy(row -> assertThat(nearestM(truths, row)).isLessThan(RADIUS_M));
        } finally {
            for (SimulatorTruth truth : truths) {
                truth.close();
            }
        }
    }

    /** The port opens a moment after the start. */
    private static SimulatorTruth truth(int number) {
        List<SimulatorTruth> open = new ArrayList<>();
        Await.until("boat " + number + " listens", () -> {
            try {
                return open.add(new SimulatorTruth(ArduPilotBoats.secondPort(number), number + 1));
            } catch (IOException notYet) {
                return false;
            }
        });
        return open.get(0);
    }

    private static double nearestM(List<SimulatorTruth> truths, String row) {
        String[] cells = row.split(",", -1);
        double latDeg = Double.parseDouble(cells[1]);
        double lonDeg = Double.parseDouble(cells[2]);
        return truths.stream()
                .mapToDouble(truth -> truth.nearestM(latDeg, lonDeg))
                .min()
                .orElseThrow();
    }
}
