package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.NearbyBoat;
import org.sami.boat.link.NoGoEdge;
import org.sami.boat.link.NoGoEdges;
import org.sami.boat.link.Traffic;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.traffic.CourseAndSpeed;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.vehicle.VehiclePosition;

/** Vehicles that are steered by the rule, on a hull that turns and brakes as ArduPilot's simulated boat does, in a computed time. */
class VehicleGivingWayTest {
    private static final LocalFrame PLANE = new LocalFrame(45.7, 10.72);
    private static final double MPS = 1.5;
    private static final double APART_M = 3;
    private static final double ARRIVED_M = 2.5;
    private static final long STEP_MS = 100;
    private static final long HEARD_EVERY_MS = 250;
    private static final double STEP_S = STEP_MS / 1000.0;

    private final List<Hull> hulls = new ArrayList<>();
    private Optional<NoGoEdges> edges = Optional.empty();
    private long nowMs;
    private double leastM = Double.MAX_VALUE;

    /** A hull with its rule, on the way to a place; its autopilot would drive straight there. */
    private final class Hull {
        private static final double TURN_RAD_S = 1;
        private static final double GAIN_MPS2 = 1;
        private static final double TURN_RADIUS_M = 0.9;

        private final String name;
        private final VehicleGivingWay rule;
        private final VehicleTarget target;
        private double eastM;
        private double northM;
        private double headingRad;
        private double speedMps;
        private VehiclePosition said = new VehiclePosition(0, 0, 0, 0, Optional.empty(), 0, 0);
        private boolean gaveWay;
        private double farthestEastM = -Double.MAX_VALUE;

        Hull(String name, double eastM, double northM, double toEastM, double toNorthM) {
            this.name = name;
            this.eastM = eastM;
            this.northM = northM;
            rule = new VehicleGivingWay(name);
            headingRad = Math.atan2(toEastM - eastM, toNorthM - northM);
            Waypoint place = new Waypoint(PLANE.latDeg(toEastM, toNorthM), PLANE.lonDeg(toEastM, toNorthM), MPS);
            target = new VehicleTarget("list", 0, place, MPS, true);
        }

        void say() {
            said = new VehiclePosition(
                    PLANE.latDeg(eastM, northM),
                    PLANE.lonDeg(eastM, northM),
                    0,
                    Math.abs(speedMps),
                    Optional.of(Math.toDegrees(headingRad)),
                    nowMs,
                    nowMs);
        }

        NearbyBoat row() {
            return new NearbyBoat(
                    name,
                    said.latDeg(),
                    said.lonDeg(),
                    Math.IEEEremainder(headingRad, 2 * Math.PI),
                    said.speedMps(),
                    isThere() ? BoatMode.HOLD : BoatMode.PATH,
                    nowMs - said.heardMs());
        }

        boolean isThere() {
            return Math.hypot(
                            eastM
                                    - PLANE.eastM(
                                            target.place().latDeg(),
                                            target.place().lonDeg()),
                            northM
                                    - PLANE.northM(
                                            target.place().latDeg(),
                                            target.place().lonDeg()))
                    < ARRIVED_M;
        }

        void move() {
            CourseAndSpeed chosen = isThere() ? new CourseAndSpeed(headingRad, 0) : rule.choose(said, target, nowMs);
            gaveWay |= rule.isGivingWay();
            double turn = Math.IEEEremainder(chosen.courseRad() - headingRad, 2 * Math.PI);
            double rudderRadS = Math.min(TURN_RAD_S, Math.abs(speedMps) / TURN_RADIUS_M);
            headingRad += clamped(turn, rudderRadS * STEP_S);
            speedMps += clamped(chosen.speedMps() - speedMps, GAIN_MPS2 * STEP_S);
            eastM += speedMps * Math.sin(headingRad) * STEP_S;
            northM += speedMps * Math.cos(headingRad) * STEP_S;
            farthestEastM = Math.max(farthestEastM, eastM);
        }
    }

    private static double clamped(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }

    /** Lets time pass until all have arrived, or a limit. The seconds that it took. */
    private double run(double limitS) {
        long endMs = Math.round(limitS * 1000);
        for (nowMs = 0; nowMs < endMs && !hulls.stream().allMatch(Hull::isThere); nowMs += STEP_MS) {
            if (nowMs % HEARD_EVERY_MS == 0) {
                hulls.forEach(Hull::say);
            }
            if (nowMs % (2 * STEP_MS) == 0) {
                List<NearbyBoat> rows = hulls.stream().map(Hull::row).toList();
                hulls.forEach(hull -> hull.rule.update(new Traffic(rows, edges), nowMs));
            }
            hulls.forEach(Hull::move);
            for (Hull one : hulls) {
                for (Hull other : hulls.subList(0, hulls.indexOf(one))) {
                    leastM = Math.min(leastM, Math.hypot(one.eastM - other.eastM, one.northM - other.northM));
                }
            }
        }
        return nowMs / 1000.0;
    }

    @Test
    void twoThatMeetPassWithLittleDelay() {
        hulls.add(new Hull("mav1", 0, 0, 0, 60));
        hulls.add(new Hull("mav2", 0, 60, 0, 0));

        double seconds = run(120);

        assertThat(seconds).isLessThan(1.3 * 60 / MPS);
        assertThat(leastM).isGreaterThan(APART_M);
        assertThat(hulls.get(1).gaveWay).isTrue();
    }

    @Test
    void fourThatCrossInOnePointPass() {
        hulls.add(new Hull("mav1", 0, -30, 0, 30));
        hulls.add(new Hull("mav2", -30, 0, 30, 0));
        hulls.add(new Hull("mav3", 0, 30, 0, -30));
        hulls.add(new Hull("mav4", 30, 0, -30, 0));

        double seconds = run(240);

        assertThat(seconds).isLessThan(120);
        assertThat(leastM).isGreaterThan(APART_M);
    }

    @Test
    void faultlessWayIsNotLeft() {
        hulls.add(new Hull("mav1", 0, 0, 0, 40));
        hulls.add(new Hull("mav2", 15, 40, 15, 0));

        run(60);

        assertThat(hulls).noneMatch(hull -> hull.gaveWay).allMatch(Hull::isThere);
    }

    @Test
    void oneThatGivesWayStaysOutsideANoGoArea() {
        double shoreM = 3; // east of the line
        edges = Optional.of(new NoGoEdges(
                1,
                List.of(new NoGoEdge(
                        PLANE.latDeg(shoreM, -20),
                        PLANE.lonDeg(shoreM, -20),
                        PLANE.latDeg(shoreM, 80),
                        PLANE.lonDeg(shoreM, 80)))));
        hulls.add(new Hull("mav1", 0, 0, 0, 60));
        hulls.add(new Hull("mav2", 0, 60, 0, 0));

        run(240);

        assertThat(hulls).allSatisfy(hull -> {
            assertThat(hull.isThere()).isTrue();
            assertThat(hull.farthestEastM).isLessThan(shoreM);
        });
        assertThat(leastM).isGreaterThan(APART_M);
    }

    @Test
    void nobodyNearIsNoReason() {
        VehicleGivingWay rule = new VehicleGivingWay("mav1");

        CourseAndSpeed chosen = rule.choose(
                new VehiclePosition(45.7, 10.72, 0, MPS, Optional.of(90.0), 0, 0),
                new VehicleTarget("list", 0, new Waypoint(45.71, 10.72, MPS), MPS, false),
                0);

        assertThat(rule.isGivingWay()).isFalse();
        assertThat(chosen.courseRad()).isCloseTo(0, within(1e-3));
    }
}
