package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.vehicle.VehicleBattery;
import org.sami.mavlink.vehicle.VehicleHealth;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** How far a percent of charge takes a vehicle is counted while it drives. */
class VehicleConsumptionTest {
    private static final LocalFrame PLANE = new LocalFrame(45.7, 10.72);

    @TempDir
    private Path folder;

    private final VehicleConsumption consumption = new VehicleConsumption(0, 0);
    private double northM;
    private long nowMs;
    private int percent = 100;

    private void see() {
        consumption.reported(snapshot());
    }

    private VehicleSnapshot snapshot() {
        VehiclePosition at = new VehiclePosition(
                PLANE.latDeg(0, northM), PLANE.lonDeg(0, northM), 0, 1, Optional.empty(), nowMs, nowMs);
        return new VehicleSnapshot(
                new VehicleId(7, 1),
                VehicleKind.BOAT,
                "ArduPilot",
                "AUTO",
                true,
                true,
                Optional.of(at),
                Optional.of(new VehicleBattery(Optional.empty(), Optional.of(percent))),
                Optional.empty(),
                new VehicleHealth(true, false, false, Optional.empty(), List.of()),
                Optional.empty(),
                Optional.empty(),
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                nowMs,
                List.of(),
                Optional.empty());
    }

    /** Drives at 1 m/s and uses a percent every so many metres. */
    private void drive(int percents, int metresEach) {
        for (int i = 0; i < percents; i++) {
            for (int metre = 0; metre < metresEach; metre += 5) {
                nowMs += 5_000;
                northM += 5;
                see();
            }
            percent--;
            see();
        }
    }

    private void lie(int seconds) {
        for (int second = 0; second < seconds; second += 10) {
            nowMs += 10_000;
            see();
        }
    }

    @Test
    void rangeIsKnownAfterSomePercentsOfDriving() {
        see();
        drive(5, 100);
        assertThat(consumption.metresPerPercent()).isEmpty(); // the first one may have begun before

        drive(1, 100);
        assertThat(consumption.metresPerPercent().orElseThrow()).isCloseTo(100, within(2.0));
    }

    @Test
    void chargeOfAVehicleThatLiesStillAndAnotherBatteryDoNotCount() {
        see();
        drive(7, 100);
        lie(3_000);
        percent--;
        see();
        percent = 100;
        see();
        drive(2, 100);

        assertThat(consumption.percent()).isEqualTo(8);
        assertThat(consumption.metresPerPercent().orElseThrow()).isCloseTo(100, within(2.0));
    }

    @Test
    void jumpOfThePositionIsNotDriven() {
        see();
        drive(6, 100);
        northM += 5_000;
        drive(2, 100);

        assertThat(consumption.metresPerPercent().orElseThrow()).isCloseTo(100, within(3.0));
    }

    @Test
    void whatWasCountedIsKeptAndADamagedFileIsNothing() throws Exception {
        VehicleFiles files = new VehicleFiles(folder);
        files.write("mav7", new VehicleConsumption(1234.5, 10));

        assertThat(files.consumption("mav7").metresPerPercent().orElseThrow()).isEqualTo(123.45);
        Files.writeString(folder.resolve("mav7.consumption"), "12\nmany\n");
        assertThat(files.consumption("mav7").metresPerPercent()).isEmpty();
        Files.writeString(folder.resolve("mav7.consumption"), "NaN\n5\n");
        assertThat(files.consumption("mav7").metresPerPercent()).isEmpty();
        assertThat(files.consumption("mav8").metresPerPercent()).isEmpty();
    }
}
