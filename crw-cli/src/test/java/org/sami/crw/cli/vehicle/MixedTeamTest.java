package org.sami.crw.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.value.GeoPoint;

/** A simulated boat, one of ours over TCP and one that speaks MAVLink, which is twice as fast, in one plan. */
@Tag("long")
@Timeout(900)
class MixedTeamTest {
    private static final GeoPoint CENTRE = GeoPoint.of(45.7, 10.72);
    private static final float FAST_MPS = 3; // the others drive at 1.5 m/s

    @TempDir
    private Path work;

    private static SmallBoat fast() throws Exception {
        SmallBoat boat = new SmallBoat(9, CENTRE.latDeg() - 0.0003, CENTRE.lonDeg() + 0.0002, 1);
        boat.parameter("WP_SPEED", FAST_MPS);
        return boat;
    }

    @Test
    void eachLocationIsTrulyVisitedAndTheFasterBoatHasMostOfTheWay() throws Exception {
        try (SmallBoat vehicle = fast();
                MixedTeam team = new MixedTeam(CENTRE, 80, vehicle.address() + "/9", vehicle::nearestM)) {
            Path report = work.resolve("report");
            team.run(report, "clv", "--locations", "16");

            team.assertVisited(report, 16);
            assertThat(vehicle.movedM()).isGreaterThan(1.3 * Math.max(team.distanceM("anna"), team.distanceM("boat1")));
            assertThat(Math.min(team.distanceM("anna"), team.distanceM("boat1")))
                    .isGreaterThan(20);
        }
    }

    @Test
    void simulatedBoatMeasuresBesideConnectedOnes() throws Exception {
        try (SmallBoat vehicle = fast();
                MixedTeam team = new MixedTeam(CENTRE, 40, vehicle.address() + "/9", vehicle::nearestM)) {
            Path report = work.resolve("report");
            team.run(report, "clv", "--locations", "3", "--sensor", "oxygen@2", "--current", "0.1@90");

            assertThat(Files.readAllLines(report.resolve("readings.csv")))
                    .hasSizeGreaterThan(10)
                    .anyMatch(row -> row.startsWith("boat1,") && row.contains("oxygen"))
                    .noneMatch(row -> row.startsWith("anna,") || row.startsWith("mav9,"));
        }
    }

    @Test
    void areaIsTrulyExploredAndTheFasterBoatHasLanesOfNearlyTwiceTheLength() throws Exception {
        try (SmallBoat vehicle = fast();
                MixedTeam team = new MixedTeam(CENTRE, 60, vehicle.address() + "/9", vehicle::nearestM)) {
            String out = team.run(work.resolve("report"), "explore-area", "--set", "@spacing=10");

            assertThat(team.leastCoveredM()).isLessThan(10 / 2.0 + 1.5);
            MixedTeam.assertFastBoatHasNearlyHalfOfTheLanes(out);
            assertThat(vehicle.movedM()).isGreaterThan(180);
        }
    }
}
