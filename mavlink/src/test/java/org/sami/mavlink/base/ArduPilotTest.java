package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.testing.UdpFaultProxy;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** The firmware of real autopilots, in its own simulator. */
@Timeout(600)
class ArduPilotTest {
    private static final Path PEERS = Path.of("../../shared/peers/ardupilot");
    private static final int FIRST = 96; // far from where somebody tries one by hand
    private static final double BOOT_S = 180;
    private static final int ITEMS = 100;
    private static final int MOST_WITH_A_CARD = 4_300;
    private static final double BASE_WAITS_S = 20; // for an answer of a boat

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

    @Test
    void boatTakesAMissionOverALinkThatLosesDoublesAndReorders() throws Exception {
        assumeTrue(
                Files.isExecutable(PEERS.resolve("run.sh")),
                () -> "no autopilot is here to try: " + PEERS.toAbsolutePath().normalize() + " is missing");
        try (UdpFaultProxy proxy = new UdpFaultProxy(3)) {
            Process boat = start("boat", FIRST + 2, Map.of("UDP", "127.0.0.1:" + proxy.vehiclePort()));
            MavlinkAddress address = new MavlinkAddress.UdpSend("127.0.0.1", proxy.basePort());
            try (MavlinkBase base = new MavlinkBase(List.of(address), ProcessClock::ms)) {
                Await.until(
                        "it knows where it is",
                        BOOT_S,
                        () -> vehicles(base).stream().anyMatch(VehicleSnapshot::located));
                VehicleId id = vehicles(base).get(0).id();
                proxy.disturb(0.05, 0.05, 10);
                List<MissionItem> back =
                        base.replace(id, HeldKind.MISSION, mission(ITEMS)).join();
                assertThat(back.subList(1, ITEMS)).isEqualTo(mission(ITEMS).subList(1, ITEMS));
                assertThat(base.setMode(id, "AUTO").join().inWords()).contains("accepts to change to AUTO");
            } finally {
                end(boat);
            }
        }
    }

    /** At the speed of real time. */
    @Test
    void boatWithAMemoryCardTakesALongMissionInSeconds() throws Exception {
        assumeTrue(
                Files.isExecutable(PEERS.resolve("run.sh")),
                () -> "no autopilot is here to try: " + PEERS.toAbsolutePath().normalize() + " is missing");
        Path card = Files.writeString(work.resolve("card.parm"), "BRD_SD_MISSION 64\n");
        Process boat = start("boat", FIRST + 3, "1", Map.of("PARAMS", card.toString()));
        try (MavlinkBase base = new MavlinkBase(List.of(address(FIRST + 3)), ProcessClock::ms)) {
            Await.until("it is heard", BOOT_S, () -> !vehicles(base).isEmpty());
            VehicleId id = vehicles(base).get(0).id();
            Await.until("it has started", BOOT_S, () -> isTaken(base, id, mission(ITEMS)));

            long began = ProcessClock.ms();
            base.replace(id, HeldKind.MISSION, mission(2_000)).join();
            long replaced = ProcessClock.ms();
            base.held(id, HeldKind.MISSION).join();
            System.out.printf(
                    "2000 items sent and read back in %d ms, read in %d ms%n",
                    replaced - began, ProcessClock.ms() - replaced);

            assertThat((replaced - began) / 1000.0).isLessThan(BASE_WAITS_S);
            assertThat(isTaken(base, id, mission(MOST_WITH_A_CARD))).isTrue();
            assertThat(isTaken(base, id, mission(MOST_WITH_A_CARD + ITEMS))).isFalse();
        } finally {
            end(boat);
        }
    }

    private static boolean isTaken(MavlinkBase base, VehicleId id, List<MissionItem> mission) {
        return base.replace(id, HeldKind.MISSION, mission)
                .handle((back, failure) -> failure == null)
                .join();
    }

    private static List<MissionItem> mission(int items) {
        return IntStream.range(0, items)
                .mapToObj(i -> MissionItem.waypoint(i, 45.7 + i * 1e-5, 10.72, 0, 0))
                .toList();
    }

    private static MavlinkAddress address(int number) {
        return new MavlinkAddress.Tcp("127.0.0.1", 5760 + 10 * number);
    }

    private static List<VehicleSnapshot> vehicles(MavlinkBase base) {
        return base.vehicles().join();
    }

    private Process start(String kind, int number) throws Exception {
        return start(kind, number, Map.of());
    }

    private Process start(String kind, int number, Map<String, String> more) throws Exception {
        return start(kind, number, "10", more);
    }

    private Process start(String kind, int number, String speed, Map<String, String> more) throws Exception {
        ProcessBuilder builder = new ProcessBuilder("bash", "run.sh", kind, "1", speed)
                .directory(PEERS.toFile())
                .redirectErrorStream(true)
                .redirectOutput(new File(work.toFile(), kind + ".txt"));
        builder.environment().put("FIRST", Integer.toString(number));
        builder.environment().putAll(more);
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
