package org.sami.crw.sim.hull;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import net.sf.geographiclib.Geodesic;
import org.junit.jupiter.api.Test;
import org.sami.boat.server.vehicle.LocalFrame;

class SimulatedHullTest {
    private static final LocalFrame FRAME = new LocalFrame(45.4, 10.9);
    private static final double TICK_S = 0.1;

    private final SimulatedHull hull = hull(1);

    private static SimulatedHull hull(long seed) {
        return new SimulatedHull(HullConfig.DEFAULT, FRAME, 0, 0, seed);
    }

    private static void drive(SimulatedHull hull, double port, double starboard, double seconds) {
        hull.setMotors(port, starboard);
        for (int i = 0; i < Math.round(seconds / TICK_S); i++) {
            hull.step(TICK_S);
        }
    }

    @Test
    void driveStraightAheadWithEqualEfforts() {
        drive(hull, 0.5, 0.5, 60);

        assertThat(hull.speedMps()).isCloseTo(1.6, within(1e-9));
        assertThat(hull.eastM()).isZero();
        assertThat(hull.northM()).isCloseTo(60 * 1.6 - 1.6 * 1.6 / 0.6 / 2, within(0.1));
        assertThat(hull.distanceM()).isCloseTo(hull.northM(), within(1e-9));
    }

    @Test
    void topSpeedIsAtLeastTwiceTheCruiseSpeed() {
        drive(hull, 1, 1, 20);

        assertThat(hull.speedMps()).isEqualTo(3.2).isGreaterThanOrEqualTo(2 * 1.5);
    }

    @Test
    void turnsToStarboardWhenPortPushesMore() {
        drive(hull, 0.3, 0.1, 1);

        assertThat(hull.headingRad()).isBetween(0.05, 0.1);
        assertThat(hull.eastM()).isPositive();
        drive(hull, -1, 1, 2);
        assertThat(hull.headingRad()).isNegative();
    }

    @Test
    void limitsHoldForAnyEfforts() {
        SplittableRandom random = new SplittableRandom(8);
        for (int i = 0; i < 20_000; i++) {
            double speed = hull.speedMps();
            double turn = hull.turnRateRadPerS();
            double eastM = hull.eastM();
            double northM = hull.northM();
            hull.setMotors(random.nextDouble(-2, 2), random.nextDouble(-2, 2));
            hull.step(TICK_S);

            assertThat(Math.abs(hull.speedMps())).isLessThanOrEqualTo(3.2);
            assertThat(Math.abs(hull.speedMps() - speed)).isLessThanOrEqualTo(0.6 * TICK_S + 1e-12);
            assertThat(Math.abs(hull.turnRateRadPerS())).isLessThanOrEqualTo(0.9);
            assertThat(Math.abs(hull.turnRateRadPerS() - turn)).isLessThanOrEqualTo(2.0 * TICK_S + 1e-12);
            assertThat(Math.hypot(hull.eastM() - eastM, hull.northM() - northM)).isLessThanOrEqualTo(0.32 + 1e-12);
            assertThat(Math.abs(hull.headingRad())).isLessThanOrEqualTo(Math.PI);
        }
    }

    @Test
    void batteryDrainsWithTheDistanceWithinATenth() {
        HullConfig config = HullConfig.DEFAULT;
        for (int step = 0; step < 3000; step++) {
            double before = hull.batteryPercent();
            double distance = hull.distanceM();
            hull.setMotors(0.5, 0.5);
            hull.step(TICK_S);
            double mean = config.batteryPercentPerM() * (hull.distanceM() - distance);

            assertThat(before - hull.batteryPercent()).isBetween(0.9 * mean - 1e-12, 1.1 * mean + 1e-12);
        }

        double mean = config.batteryPercentPerM() * hull.distanceM();
        assertThat(100 - hull.batteryPercent()).isBetween(0.9 * mean, 1.1 * mean);
    }

    @Test
    void boatsDifferByATenthOverALeg() {
        SplittableRandom seeds = new SplittableRandom(5);
        double[] parts = new double[200]; // of what the leg costs on the average
        for (int i = 0; i < parts.length; i++) {
            SimulatedHull boat = hull(seeds.nextLong());
            drive(boat, 0.5, 0.5, 300);
            parts[i] = (100 - boat.batteryPercent()) / (HullConfig.DEFAULT.batteryPercentPerM() * boat.distanceM());
        }

        assertThat(Arrays.stream(parts).min().orElseThrow()).isBetween(0.9, 0.91);
        assertThat(Arrays.stream(parts).max().orElseThrow()).isBetween(1.09, 1.1);
        assertThat(Arrays.stream(parts).average().orElseThrow()).isCloseTo(1, within(0.02));
    }

    @Test
    void dischargeIsDrawnAnewAfterEachInterval() {
        Conditions everyMinute = new Conditions(0, 0, Flow.NONE, Flow.NONE, List.of(), 60);
        SimulatedHull boat = new SimulatedHull(HullConfig.DEFAULT, everyMinute, FRAME, 0, 0, 3);
        drive(boat, 0.5, 0.5, 6); // at speed
        Set<Long> costs = new HashSet<>(); // of a metre, in millionths of the mean
        for (int step = 0; step < 6000; step++) {
            double before = boat.batteryPercent();
            double distance = boat.distanceM();
            drive(boat, 0.5, 0.5, TICK_S);
            double mean = HullConfig.DEFAULT.batteryPercentPerM() * (boat.distanceM() - distance);
            costs.add(Math.round((before - boat.batteryPercent()) / mean * 1e6));
        }

        assertThat(costs).hasSizeBetween(10, 22); // 11 draws, each rounded to one or two values
    }

    @Test
    void withoutAnIntervalTheDrawsAverageOut() {
        Conditions eachStep = new Conditions(0, 0, Flow.NONE, Flow.NONE, List.of(), 0);
        SimulatedHull boat = new SimulatedHull(HullConfig.DEFAULT, eachStep, FRAME, 0, 0, 3);
        drive(boat, 0.5, 0.5, 300);

        double mean = HullConfig.DEFAULT.batteryPercentPerM() * boat.distanceM();
        assertThat((100 - boat.batteryPercent()) / mean).isCloseTo(1, within(0.005));
    }

    @Test
    void oneBatteryLastsThreeToFourKilometres() {
        drive(hull, 0.47, 0.47, 4000);

        assertThat(hull.batteryPercent()).isZero();
        assertThat(hull.speedMps()).isZero();
        assertThat(hull.distanceM()).isBetween(3000.0, 4000.0);
        double atM = hull.distanceM();
        hull.recharge();
        drive(hull, 0.5, 0.5, 10);
        assertThat(hull.recharges()).isEqualTo(1);
        assertThat(hull.distanceM()).isGreaterThan(atM + 10);
    }

    @Test
    void lyingStillCostsNothing() {
        drive(hull, 0, 0, 1000);

        assertThat(hull.batteryPercent()).isEqualTo(100);
        assertThat(hull.distanceM()).isZero();
    }

    @Test
    void equalSeedsGiveEqualHulls() {
        SimulatedHull twin = hull(1);
        SimulatedHull other = hull(2);
        for (SimulatedHull each : new SimulatedHull[] {hull, twin, other}) {
            drive(each, 0.7, 0.65, 300);
        }

        assertThat(twin.batteryPercent()).isEqualTo(hull.batteryPercent());
        assertThat(twin.latDeg()).isEqualTo(hull.latDeg());
        assertThat(other.batteryPercent()).isNotEqualTo(hull.batteryPercent());
    }

    @Test
    void positionsAreTrueOnTheEllipsoid() {
        drive(hull, 0.5, 0.5, 1200);
        double trueM = Geodesic.WGS84.Inverse(45.4, 10.9, hull.latDeg(), hull.lonDeg()).s12;

        assertThat(hull.northM()).isGreaterThan(1900);
        assertThat(trueM).isCloseTo(hull.northM(), within(0.01));
    }

    @Test
    void refusesNonsense() {
        assertThatThrownBy(() -> hull.setMotors(Double.NaN, 0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> hull.step(0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> hull.setBatteryPercent(101)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new HullConfig(0, 1, 1, 1, 1)).isInstanceOf(IllegalArgumentException.class);
    }
}
