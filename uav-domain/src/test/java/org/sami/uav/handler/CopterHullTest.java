package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.Geodesy;
import org.sami.crw.sim.clock.VirtualClock;
import org.sami.crw.sim.fleet.FleetConfig;
import org.sami.crw.sim.fleet.SimulatedBoat;
import org.sami.crw.sim.fleet.SimulatedFleet;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.crw.sim.hull.SimulatedHull;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** The simulated copter: its hull, and the same boat server and link on it. */
class CopterHullTest {
    private final SimulatedHull hull = new SimulatedHull(HullConfig.COPTER, new LocalFrame(45.7, 10.72), 0, 0, 1);

    private void pass(double seconds) {
        for (int i = 0; i < seconds * 10; i++) {
            hull.step(0.1);
        }
    }

    @Test
    void takesOffStraightUpAndThenClimbsUnderWay() {
        hull.setMotors(1, 1);
        pass(5);
        assertThat(hull.northM()).isZero();

        hull.setAltitude(20);
        pass(6);
        assertThat(hull.altM().orElseThrow()).isGreaterThan(17);
        assertThat(hull.northM()).isZero();

        pass(10);
        assertThat(hull.altM()).hasValue(20);
        assertThat(hull.isAtAltitude()).isTrue();
        assertThat(hull.northM()).isGreaterThan(40);

        double before = hull.northM();
        hull.setAltitude(40);
        pass(3);
        assertThat(hull.altM().orElseThrow()).isGreaterThan(25);
        assertThat(hull.northM()).isGreaterThan(before + 10);
    }

    @Test
    void sinksToTheGroundWithoutCharge() {
        hull.setAltitude(20);
        pass(10);
        hull.setBatteryPercent(0);
        pass(11);

        assertThat(hull.altM()).hasValue(0);
    }

    @Test
    void climbsNoHigherThanItsCeiling() {
        hull.setAltitude(500);
        pass(60);

        assertThat(hull.altM()).hasValue(120);
    }

    @Test
    void reachesWaypointsAtTheirAltitudesAndLands() {
        VirtualClock clock = new VirtualClock();
        SimulatedBoat copter = fleet(clock).boats().get(0);
        GeoPoint home = copter.position();
        GeoPoint there = at(Geodesy.offset(home, 0, 60), 25);

        fly(copter, at(home, 10), there, at(there, 0));
        clock.runUntil(100_000);

        assertThat(Geodesy.distanceM(copter.position(), there)).isLessThan(3);
        assertThat(copter.hull().altM()).hasValue(0);
        assertThat(copter.proxy().isFlying()).isTrue();
        assertThat(copter.proxy().isAtRest()).isTrue();
    }

    @Test
    void returnsAtItsAltitudeAndLandsWhenItsLinkIsLost() {
        VirtualClock clock = new VirtualClock();
        SimulatedBoat copter = fleet(clock).boats().get(0);
        GeoPoint home = copter.position();
        fly(copter, at(Geodesy.offset(home, 0, 300), 25));
        clock.runUntil(40_000);
        assertThat(copter.hull().altM().orElseThrow()).isCloseTo(25, within(0.6));

        copter.toBoat().setCut(true);
        copter.toBase().setCut(true);
        clock.runUntil(55_000);
        assertThat(copter.hull().altM().orElseThrow()).isCloseTo(25, within(0.6));
        clock.runUntil(200_000);

        assertThat(Geodesy.distanceM(copter.position(), home)).isLessThan(3.1);
        assertThat(copter.hull().altM()).hasValue(0);
    }

    @Test
    void landsWhereItIsWhenItsLinkIsLostAndItIsToTurnItsMotorsOff() {
        VirtualClock clock = new VirtualClock();
        SimulatedBoat copter = fleet(clock, LostLinkAction.DRIFT).boats().get(0);
        GeoPoint home = copter.position();
        fly(copter, at(Geodesy.offset(home, 0, 300), 25));
        clock.runUntil(40_000);
        assertThat(copter.hull().altM().orElseThrow()).isCloseTo(25, within(0.6));

        copter.toBoat().setCut(true);
        copter.toBase().setCut(true);
        clock.runUntil(100_000);

        assertThat(copter.hull().altM()).hasValue(0);
        assertThat(Geodesy.distanceM(copter.position(), home)).isGreaterThan(100);
    }

    @Test
    void fleetStopKeepsItInTheAirWhenItsLinkIsLostThen() {
        VirtualClock clock = new VirtualClock();
        SimulatedBoat copter = fleet(clock, LostLinkAction.DRIFT).boats().get(0);
        fly(copter, at(Geodesy.offset(copter.position(), 0, 300), 25));
        clock.runUntil(40_000);
        copter.proxy().fleetStop();
        clock.runUntil(42_000);

        copter.toBoat().setCut(true);
        copter.toBase().setCut(true);
        clock.runUntil(100_000);

        assertThat(copter.hull().altM().orElseThrow()).isCloseTo(25, within(0.6));
    }

    private static SimulatedFleet fleet(VirtualClock clock) {
        return fleet(clock, LostLinkAction.RETURN);
    }

    private static SimulatedFleet fleet(VirtualClock clock, LostLinkAction lostLink) {
        SimulatedFleet fleet = new SimulatedFleet(
                clock,
                1,
                1,
                45.7,
                10.72,
                id -> event -> {},
                FleetConfig.DEFAULT.withHull(HullConfig.COPTER).withServer(server -> server.lostLinkAction(lostLink)));
        fleet.start();
        clock.runUntil(1000);
        return fleet;
    }

    private static void fly(SimulatedBoat copter, GeoPoint... points) {
        copter.proxy()
                .commands()
                .submit(new FollowPath("m1", 1, 1, List.of(points), OptionalDouble.of(8), 0, Priority.MEDIUM, false));
    }

    private static GeoPoint at(GeoPoint point, double altM) {
        return new GeoPoint(point.latDeg(), point.lonDeg(), altM);
    }
}
