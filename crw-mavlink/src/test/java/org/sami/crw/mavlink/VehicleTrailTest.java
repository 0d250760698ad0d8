package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.vehicle.VehiclePosition;

class VehicleTrailTest {
    private static final double SPEED_MPS = 1;
    private final LocalFrame frame = new LocalFrame(45.7, 10.72);
    private final VehicleTrail trail = new VehicleTrail(() -> 2);
    private long nowMs;
    private long bootMs = 60_000;

    @Test
    void waypointsThatItDroveAlongAreNotSkipped() {
        drive(0, 0, 60, 0);
        drive(60, 0, 60, 40);

        assertThat(trail.skipped(List.of(at(30, 3), at(60, 0), at(60, 40)), nowMs - 1))
                .isEmpty();
    }

    @Test
    void aWaypointBesideItsWayIsSkipped() {
        drive(0, 0, 60, 0);

        assertThat(trail.skipped(List.of(at(30, 0), at(30, 20)), nowMs - 1)).hasValue(1);
    }

    @Test
    void whereItWasBeforeItsLastProgressDoesNotCount() {
        drive(0, 0, 60, 0);
        trail.restart();

        assertThat(trail.skipped(List.of(at(0, 0)), nowMs - 1)).hasValue(0);
        assertThat(trail.skipped(List.of(at(60, 0)), nowMs - 1)).isEmpty();
    }

    @Test
    void inASilenceItCanHaveBeenAsFarAwayAsItCouldDrive() {
        drive(0, 0, 60, 0);
        pass(30_000);
        add(60, 1);

        assertThat(trail.skipped(List.of(at(60, 35)), nowMs - 1)).isEmpty();
        assertThat(trail.skipped(List.of(at(60, 50)), nowMs - 1)).hasValue(0);
    }

    @Test
    void aSilenceIsAsLongAsTheVehiclesOwnClockSays() {
        drive(0, 0, 60, 0);
        nowMs += 3_000; // at ten times speed
        bootMs += 30_000;
        add(60, 1);

        assertThat(trail.skipped(List.of(at(60, 35)), nowMs - 1)).isEmpty();
        assertThat(trail.skipped(List.of(at(60, 50)), nowMs - 1)).hasValue(0);
    }

    @Test
    void itIsKnownWhereItIsOnceItHasSaidSo() {
        assertThat(trail.isKnownAfter(-1)).isFalse();
        drive(0, 0, 60, 0);

        assertThat(trail.isKnownAfter(nowMs - 1)).isTrue();
        assertThat(trail.isKnownAfter(nowMs)).isFalse();
        pass(250);
        add(60, 0);
        assertThat(trail.isKnownAfter(nowMs - 1)).isTrue();
    }

    @Test
    void aBoatThatLiesStillForAnHourForgetsNothingOfItsWay() {
        drive(0, 0, 60, 0);
        for (int i = 0; i < 4 * 3_600; i++) {
            pass(250);
            add(60, 0);
        }

        assertThat(trail.skipped(List.of(at(0, 0)), nowMs - 1)).isEmpty();
    }

    @Test
    void beforeItHasSaidWhereItWasThenItSkipsNothing() {
        drive(0, 0, 60, 0);

        assertThat(trail.skipped(List.of(at(30, 20)), nowMs)).isEmpty();
    }

    @Test
    void aVehicleThatHasNotSaidWhereItIsSkipsNothing() {
        assertThat(trail.skipped(List.of(at(500, 0)), nowMs - 1)).isEmpty();
    }

    /** Four reports a second, in metres east and north. */
    private void drive(double eastM, double northM, double toEastM, double toNorthM) {
        int reports = (int) (Math.hypot(toEastM - eastM, toNorthM - northM) / SPEED_MPS * 4);
        for (int i = 0; i <= reports; i++) {
            double part = i / (double) reports;
            add(eastM + part * (toEastM - eastM), northM + part * (toNorthM - northM));
            pass(i < reports ? 250 : 0);
        }
    }

    private void pass(long ms) {
        nowMs += ms;
        bootMs += ms;
    }

    private void add(double eastM, double northM) {
        Waypoint at = at(eastM, northM);
        trail.add(new VehiclePosition(at.latDeg(), at.lonDeg(), 0, SPEED_MPS, Optional.empty(), nowMs, bootMs));
    }

    private Waypoint at(double eastM, double northM) {
        return new Waypoint(frame.latDeg(eastM, northM), frame.lonDeg(eastM, northM), SPEED_MPS);
    }
}
