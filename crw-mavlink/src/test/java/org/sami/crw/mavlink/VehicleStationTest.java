package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.NearbyBoat;
import org.sami.boat.link.Traffic;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.vehicle.VehiclePosition;

/** A vehicle at the end of its path, 1 m east of it, and another boat that has to come by. */
class VehicleStationTest {
    private static final LocalFrame PLANE = new LocalFrame(45.7, 10.72);
    private static final Waypoint END = place(0, 0);
    private static final VehiclePosition AT = position(1, 0);
    private static final double KEPT_M = 4.06; // from others, at the positions' errors

    private final VehicleGivingWay vehicle = new VehicleGivingWay("mav2");
    private long nowMs = 1_000;

    private static Waypoint place(double eastM, double northM) {
        return new Waypoint(PLANE.latDeg(eastM, northM), PLANE.lonDeg(eastM, northM), 1);
    }

    private static VehiclePosition position(double eastM, double northM) {
        return new VehiclePosition(
                PLANE.latDeg(eastM, northM), PLANE.lonDeg(eastM, northM), 0, 0, Optional.of(0.0), 1_000, 1_000);
    }

    /** Another boat drives north, to a place. */
    private void other(double eastM, double northM, double speedMps, double toEastM, double toNorthM) {
        vehicle.update(
                new Traffic(List.of(new NearbyBoat(
                        "mav1",
                        PLANE.latDeg(eastM, northM),
                        PLANE.lonDeg(eastM, northM),
                        0,
                        speedMps,
                        BoatMode.PATH,
                        0,
                        PLANE.latDeg(toEastM, toNorthM),
                        PLANE.lonDeg(toEastM, toNorthM)))),
                nowMs);
    }

    private Optional<Waypoint> next(VehiclePosition at) {
        vehicle.rest(nowMs);
        return vehicle.station(at, nowMs).next(END, nowMs);
    }

    @Test
    void staysWhileNobodyHasToComeBy() {
        assertThat(next(AT)).isEmpty();

        other(20, 0, 1.5, 20, 50);
        assertThat(next(AT)).as("20 m away").isEmpty();
    }

    @Test
    void makesRoomForOneThatIsToComeThereAndGoesBackOnceItIsGone() {
        other(3, -10, 1.5, 3, 0);
        Waypoint room = next(AT).orElseThrow();
        assertThat(PLANE.distanceM(room.latDeg(), room.lonDeg())).isCloseTo(7, within(0.1));
        assertThat(new LocalFrame(place(3, 0).latDeg(), place(3, 0).lonDeg()).distanceM(room.latDeg(), room.lonDeg()))
                .isGreaterThan(KEPT_M);

        vehicle.station(AT, nowMs).sentTo(room);
        assertThat(next(AT)).as("it is on its way there").isEmpty();

        LocalFrame there = new LocalFrame(room.latDeg(), room.lonDeg());
        VehiclePosition aside =
                new VehiclePosition(there.originLatDeg(), there.originLonDeg(), 0, 0, Optional.of(0.0), nowMs, nowMs);
        other(3, 90, 1.5, 3, 200);
        assertThat(next(aside)).isEmpty();
        nowMs += 16_000;
        Waypoint back = next(aside).orElseThrow();
        assertThat(PLANE.distanceM(back.latDeg(), back.lonDeg())).isLessThan(0.1);
    }

    @Test
    void makesRoomForOneThatWaitsToPassAsFarAwayAsItKeeps() {
        other(4.5, -4, 0, 4.5, 30); // 3.5 m to the side of its way
        assertThat(next(AT)).isPresent();

        other(6, -4, 0, 6, 30);
        assertThat(next(AT)).as("it can pass").isEmpty();
    }
}
