package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** The firmware of real autopilots, in its own simulator. */
@Timeout(600)
class ArduPilotTest {
    private static final Path PEERS = Path.of("../../shared/peers/ardupilot");
    private static final int FIRST = 70; // far from where somebody tries one by hand
    private static final double BOOT_S = 180;

    @TempDir
    private Path work;

    @Test
    void boatAndCopterAreKnownOnceTheirFiltersHaveAPosition() throws Exception {
        assumeTrue(
                Files.isExecutable(PEERS.resolve("run.sh")),
                () -> "no autopilot is here to try: " + PEERS.toAbsolutePath().normalize() + " is missing");
        Process boat = start("boat", FIRST);
        Process copter = start("copter", FIRST + 1);
        try (MavlinkBase base = new MavlinkBase(List.of(address(FIRST), address(FIRST + 1)), ProcessClock::ms)) {
            Await.until(
                    "both are known and know where they are",
                    BOOT_S,
                    () -> vehicles(base).size() == 2 && vehicles(base).stream().allMatch(VehicleSnapshot::located));

            List<VehicleSnapshot> both = vehicles(base);
            assertThat(both).extracting(VehicleSnapshot::kind).containsExactly(VehicleKind.BOAT, VehicleKind.COPTER);
            assertThat(both).extracting(VehicleSnapshot::autopilot).containsOnly("ArduPilot");
            assertThat(both).noneMatch(VehicleSnapshot::armed);
            assertThat(both).allSatisfy(each -> {
                assertThat(each.position().orElseThrow().latDeg()).isBetween(45.69, 45.71);
                assertThat(each.battery().orElseThrow().volts()).isPresent();
            });
            assertThat(base.held(both.get(0).id(), HeldKind.FENCE).join()).isEmpty();
            assertThat(base.held(both.get(0).id(), HeldKind.MISSION).join()).hasSizeLessThanOrEqualTo(1);
        } finally {
            end(boat);
            end(copter);
        }
    }

    private static MavlinkAddress address(int number) {
        return new MavlinkAddress.Tcp("127.0.0.1", 5760 + 10 * number);
    }

    private static List<VehicleSnapshot> vehicles(MavlinkBase base) {
        return base.vehicles().join();
    }

    private Process start(String kind, int number) throws Exception {
        ProcessBuilder builder = new ProcessBuilder("bash", "run.sh", kind, "1", "10")
                .directory(PEERS.toFile())
                .redirectErrorStream(true)
                .redirectOutput(new File(work.toFile(), kind + ".txt"));
        builder.environment().put("FIRST", Integer.toString(number));
        builder.environment().put("WORK", work.toAbsolutePath().toString());
        return builder.start();
    }

    private static void end(Process process) throws InterruptedException {
        process.destroy();
        if (!process.waitFor(30, TimeUnit.SECONDS)) {
            process.destroyForcibly();
        }
    }
}
