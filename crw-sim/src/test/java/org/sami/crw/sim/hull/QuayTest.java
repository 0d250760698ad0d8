package org.sami.crw.sim.hull;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.sami.boat.server.vehicle.LocalFrame;

/** Batteries are swapped at the quay, of boats that have something to do and lie still. */
class QuayTest {
    private final SimulatedHull hull = new SimulatedHull(HullConfig.DEFAULT, new LocalFrame(45.7, 10.72), 0, 0, 1);

    QuayTest() {
        hull.setQuay(Quay.atOrigin());
        hull.setBatteryPercent(40);
    }

    @Test
    void boatThatWasLaunchedThereKeepsItsBattery() {
        pass(120, 0);

        assertThat(hull.batteryPercent()).isEqualTo(40);
        assertThat(hull.recharges()).isZero();
    }

    @Test
    void boatThatWasToldToGoWhereItLiesHasAFullBattery() {
        pass(60, 0);
        hull.putToUse();
        pass(9, 0);
        assertThat(hull.recharges()).isZero();
        pass(60, 0);

        assertThat(hull.batteryPercent()).isEqualTo(100);
        assertThat(hull.recharges()).isEqualTo(1);
    }

    @Test
    void boatThatWaitsAtTheQuayOnItsWayKeepsItsBattery() {
        hull.putToUse();
        hull.setUnderWay(true);
        pass(60, 0);
        assertThat(hull.recharges()).isZero();

        hull.setUnderWay(false);
        pass(11, 0);
        assertThat(hull.recharges()).isEqualTo(1);
    }

    @Test
    void boatThatDrivesNearItsQuayGetsNothing() {
        pass(1, 0);
        hull.putToUse();
        hull.setUnderWay(true);
        for (int i = 0; i < 6; i++) {
            pass(2, 0.5);
            pass(2, -0.5);
        }

        assertThat(hull.recharges()).isZero();
    }

    @Test
    void boatThatComesBackAndLiesStillHasAFullBattery() {
        pass(15, 1);
        pass(20, -1);
        stopAtTheQuay();
        double before = hull.batteryPercent();

        pass(9, 0);
        assertThat(hull.batteryPercent()).isEqualTo(before);
        pass(2, 0);

        assertThat(hull.batteryPercent()).isEqualTo(100);
        assertThat(hull.recharges()).isEqualTo(1);
    }

    @Test
    void batteryIsSwappedOnceForEachTimeItComesBack() {
        for (int round = 1; round <= 2; round++) {
            pass(15, 1);
            pass(20, -1);
            stopAtTheQuay();
            pass(60, 0);

            assertThat(hull.recharges()).isEqualTo(round);
        }
    }

    @Test
    void boatThatOnlyPassesGetsNothing() {
        pass(15, 1);
        pass(40, -1);

        assertThat(hull.recharges()).isZero();
        assertThat(hull.batteryPercent()).isLessThan(40);
    }

    @Test
    void boatThatLiesStillFartherOutGetsNothing() {
        pass(15, 1);
        pass(120, 0);

        assertThat(hull.recharges()).isZero();
    }

    @Test
    void quayReachesAlongItsWholeLine() {
        Quay quay = new Quay(-10, 30, 5, 18);

        assertThat(quay.reaches(30, 5)).isTrue();
        assertThat(quay.reaches(47, 5)).isTrue();
        assertThat(quay.reaches(49, 5)).isFalse();
        assertThat(quay.reaches(0, 24)).isFalse();
        assertThatThrownBy(() -> new Quay(1, 0, 0, 18)).hasMessageContaining("from 1.0 to 0.0");
    }

    /** From a drive astern to a rest within the quay's reach. */
    private void stopAtTheQuay() {
        for (int i = 0; i < 1000 && hull.northM() > 10; i++) {
            pass(0.1, -0.3);
        }
        for (int i = 0; i < 1000 && Math.abs(hull.speedMps()) > 0.01; i++) {
            pass(0.1, 0);
        }
        assertThat(Math.abs(hull.northM())).isLessThan(18);
    }

    private void pass(double seconds, double effort) {
        hull.setMotors(effort, effort);
        for (int i = 0; i < Math.round(seconds * 10); i++) {
            hull.step(0.1);
        }
    }
}
