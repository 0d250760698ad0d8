package org.sami.boat.hull.position;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PositionFilterTest {
    private final PositionFilter filter = new PositionFilter();

    @ParameterizedTest
    @CsvSource({"1, 1, true", "1.5, 0.5, true", "0.5, 1.4, true", "1, 1, false"})
    void positionIsNearerToTheTruthThanTheFixes(double whiteM, double wanderM, boolean motion) {
        double raw = 0;
        double filtered = 0;
        double heading = 0;
        for (long seed = 1; seed <= 5; seed++) {
            SimulatedDrive drive = new SimulatedDrive(seed, whiteM, wanderM);
            drive.givesMotion = motion;
            drive.drive(new PositionFilter(), 600);
            raw += drive.rawErrorM() / 5;
            filtered += drive.filterErrorM() / 5;
            heading += drive.headingErrorDeg() / 5;
        }
        System.out.printf(
                Locale.ROOT,
                "receiver white %.1f m, wandering %.1f m, %s: fixes %.2f m off, filter %.2f m off, heading %.1f° off%n",
                whiteM,
                wanderM,
                motion ? "with speed and course" : "positions alone",
                raw,
                filtered,
                heading);

        assertThat(filtered).isLessThan(raw * 0.95);
        assertThat(heading).isLessThan(10);
    }

    @Test
    void withoutCompassAndGyroHeadingComesFromTheCourse() {
        SimulatedDrive drive = new SimulatedDrive(1, 1, 1);
        drive.hasCompass = false;
        drive.hasGyro = false;
        drive.drive(filter, 300);

        assertThat(drive.headingErrorDeg()).isLessThan(15);
        assertThat(filter.doubts(drive.ms())).containsExactly(PositionDoubt.NO_COMPASS);
    }

    @Test
    void compassThatIsTurnedByARightAngleIsToldAndTheHeadingFollowsTheCourse() {
        SimulatedDrive drive = new SimulatedDrive(1, 1, 1);
        drive.compassErrorRad = Math.PI / 2;
        drive.drive(filter, 120);

        assertThat(filter.doubts(drive.ms())).containsExactly(PositionDoubt.COMPASS_DISAGREES);
        assertThat(Math.toDegrees(filter.disagreementRad())).isCloseTo(90, within(20.0));
        assertThat(Math.toDegrees(drive.headingOffRad(filter.pose(drive.ms())))).isLessThan(20);
    }

    @Test
    void compassThatFitsIsNotDoubted() {
        SimulatedDrive drive = new SimulatedDrive(2, 1, 1);
        drive.drive(filter, 300);

        assertThat(filter.doubts(drive.ms())).isEmpty();
    }

    @Test
    void jumpThatPassesIsNotFollowed() {
        SimulatedDrive drive = new SimulatedDrive(1, 0.5, 0.5);
        drive.gpsOffEastM = time -> time > 30 && time < 32 ? 80 : 0;
        drive.drive(filter, 31.9);
        assertThat(drive.offM(filter.pose(drive.ms()))).isLessThan(6);
        assertThat(filter.doubts(drive.ms())).containsExactly(PositionDoubt.GPS_IMPLAUSIBLE);

        drive.drive(filter, 5);
        assertThat(drive.offM(filter.pose(drive.ms()))).isLessThan(4);
        assertThat(filter.doubts(drive.ms())).isEmpty();
    }

    @Test
    void positionThatStaysElsewhereIsTakenAfterThreeSeconds() {
        SimulatedDrive drive = new SimulatedDrive(1, 0.5, 0.5);
        drive.gpsOffEastM = time -> time > 30 ? 500 : 0;
        drive.drive(filter, 40);

        assertThat(drive.offM(filter.pose(drive.ms()))).isCloseTo(500, within(5.0));
    }

    @Test
    void gapIsBridgedByCompassAndSpeedAndItsErrorGrows() {
        SimulatedDrive drive = new SimulatedDrive(1, 0.5, 0.5);
        drive.gpsThere = time -> time > 41 && time < 49 ? 0 : 1;
        drive.drive(filter, 41);
        double before = filter.pose(drive.ms()).positionErrorM();
        drive.drive(filter, 7.9);

        Pose pose = filter.pose(drive.ms());
        assertThat(drive.offM(pose)).isLessThan(6);
        assertThat(pose.positionErrorM()).isGreaterThan(before);
        assertThat(filter.doubts(drive.ms())).containsExactly(PositionDoubt.NO_GPS);
    }

    @Test
    void positionIsUnknownAfterALongGapAndKnownAgainWithTheNextFix() {
        SimulatedDrive drive = new SimulatedDrive(1, 0.5, 0.5);
        drive.gpsThere = time -> time > 30 && time < 45 ? 0 : 1;
        drive.drive(filter, 44);
        assertThat(filter.pose(drive.ms()).isLocated()).isFalse();
        assertThat(filter.pose(drive.ms()).headingRad()).isNotNaN();

        drive.drive(filter, 2);
        assertThat(drive.offM(filter.pose(drive.ms()))).isLessThan(4);
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 3", "NaN, 10.9, 3", "45.4, NaN, 3", "91, 10.9, 3", "45.4, 181, 3", "45.4, 10.9, 500", "-89, 0, 3"
    })
    void positionThatMakesNoSenseIsRefused(double lat, double lon, double accuracyM) {
        filter.gps(new GpsFix(lat, lon, accuracyM, Double.NaN, Double.NaN), 0);

        assertThat(filter.pose(0).isLocated()).isFalse();
        assertThat(filter.refusedFixes()).isEqualTo(1);
        assertThat(filter.doubts(0)).contains(PositionDoubt.GPS_IMPLAUSIBLE);
    }

    @Test
    void receiverAtZeroZeroInMidPathMovesNothing() {
        SimulatedDrive drive = new SimulatedDrive(1, 0.5, 0.5);
        drive.drive(filter, 30);
        for (int i = 0; i < 20; i++) {
            filter.gps(GpsFix.at(0, 0), drive.ms());
            drive.drive(filter, 0.2);
        }

        assertThat(drive.offM(filter.pose(drive.ms()))).isLessThan(4);
    }

    @Test
    void timesThatStandStillOrRunBackDoNoHarm() {
        filter.gps(new GpsFix(45.4, 10.9, 3, 1.5, 0), 1_000_000);
        filter.compass(0.1, 1_000_000);
        filter.gps(new GpsFix(45.4, 10.9, 3, 1.5, 0), 5); // a phone's clock set to 1970
        filter.gyro(Double.NaN, 6);
        filter.compass(Double.NaN, 7);

        Pose pose = filter.pose(1_000_100);
        assertThat(pose.latDeg()).isCloseTo(45.4, within(1e-4));
        assertThat(pose.headingRad()).isCloseTo(0.1, within(0.2));
    }

    @Test
    void speedIsNegativeAstern() {
        for (int tick = 0; tick < 100; tick++) {
            long ms = tick * 100L;
            filter.motors(-0.5, 0, ms);
            filter.compass(0, ms);
            double south = -0.8 * tick / 10;
            double lat = SimulatedDrive.FRAME.latDeg(0, south);
            filter.gps(new GpsFix(lat, SimulatedDrive.FRAME.lonDegOn(lat, 0), 2, 0.8, Math.PI), ms);
        }

        assertThat(filter.pose(10_000).speedMps()).isCloseTo(-0.8, within(0.2));
        assertThat(filter.pose(10_000).headingRad()).isCloseTo(0, within(0.2));
        assertThat(filter.doubts(10_000)).isEmpty();
    }

    @Test
    void declinationTurnsTheCompassToTrueNorth() {
        filter.setDeclination(0.2);
        filter.gps(GpsFix.at(45.4, 10.9), 0);
        filter.compass(0.1, 0);

        assertThat(filter.pose(0).headingRad()).isCloseTo(0.3, within(1e-9));
    }

    @Test
    void boatThatDrivesTenKilometresKeepsItsPosition() {
        double north = 0;
        for (int tick = 0; tick < 7000; tick++) {
            north += 1.5;
            double lat = 45.4 + Math.toDegrees(north / 6_367_000);
            filter.gps(new GpsFix(lat, 10.9, 2, 7.5, 0), tick * 200L);
        }

        assertThat(filter.pose(7000 * 200L).latDeg()).isCloseTo(45.4 + Math.toDegrees(north / 6_367_000), within(1e-4));
    }
}
