package org.sami.crw.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.SimulatorTruth;
import org.sami.spn.value.GeoPoint;

/** As {@link MixedTeamTest}, with the real firmware of a boat at 3 m/s. Some four minutes, as it has the speed of real time. */
@Tag("long")
@Timeout(1200)
class ArduPilotMixedTeamTest {
    private static final int NUMBER = 76;
    private static final GeoPoint CENTRE =
            GeoPoint.of(45.7003, 10.72 + 0.0003 * NUMBER); // the boat starts 33 m south of it
    private static final String FAST = "WP_SPEED 3\nCRUISE_SPEED 3\n"; // the others drive at 1.5 m/s

    @TempDir
    private Path work;

    @Test
    void eachLocationIsTrulyVisitedAndEachLaneDriven() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = ArduPilotBoats.with(FAST, NUMBER, 1, 1, work);
                SimulatorTruth truth = truth()) {
            visit(truth);
            explore(truth);
        }
    }

    private void visit(SimulatorTruth truth) throws Exception {
        try (MixedTeam team = new MixedTeam(CENTRE, 80, ArduPilotBoats.address(NUMBER), truth::nearestM)) {
            Path report = work.resolve("visits");
            team.run(report, "clv", "--locations", "16");

            team.assertVisited(report, 16);
            assertThat(team.distanceM("mav" + (NUMBER + 1)))
                    .isGreaterThan(1.3 * Math.max(team.distanceM("anna"), team.distanceM("boat1")));
        }
    }

    private void explore(SimulatorTruth truth) throws Exception {
        int before = truth.samples();
        try (MixedTeam team = new MixedTeam(
                CENTRE, 60, ArduPilotBoats.address(NUMBER), (lat, lon) -> truth.nearestM(before, lat, lon))) {
            String out = team.run(work.resolve("lanes"), "explore-area", "--set", "@spacing=10");

            assertThat(team.leastCoveredM()).isLessThan(10 / 2.0 + 3);
            MixedTeam.assertFastBoatHasNearlyHalfOfTheLanes(out);
        }
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
}
