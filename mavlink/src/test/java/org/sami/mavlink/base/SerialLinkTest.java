package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.link.MavlinkLinkState;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.testing.SerialCable;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** A base and a vehicle on a serial port, which is a pseudo terminal: the port's library opens and sets it as any other. */
@EnabledOnOs(value = OS.LINUX, disabledReason = "pseudo terminals are opened as Linux does it")
@Timeout(300)
class SerialLinkTest {
    private static final int ITEMS = 60;

    @TempDir
    private Path folder;

    private static MavlinkBase base(String address) {
        return new MavlinkBase(List.of(AddressText.parse(address)), ProcessClock::ms);
    }

    private static List<VehicleSnapshot> vehicles(MavlinkBase base) {
        return base.vehicles().join();
    }

    private static VehicleId known(MavlinkBase base) {
        Await.until("it is known where it is", () -> vehicles(base).stream().anyMatch(VehicleSnapshot::located));
        return vehicles(base).get(0).id();
    }

    private static List<MissionItem> mission() {
        return IntStream.range(0, ITEMS)
                .mapToObj(number -> MissionItem.waypoint(number, 45.7 + number * 0.00002, 10.72, 0, 0))
                .toList();
    }

    @Test
    void vehicleOnASerialPortIsHeardGivenAMissionAndCommanded() throws Exception {
        try (SmallBoat boat = new SmallBoat(7, 45.7, 10.72, 1);
                SerialCable cable = new SerialCable(folder.resolve("radio"), boat.address());
                MavlinkBase base = base(cable.address())) {
            VehicleId id = known(base);

            base.replace(id, HeldKind.MISSION, mission()).join();
            List<MissionItem> held = base.held(id, HeldKind.MISSION).join();

            assertThat(vehicles(base).get(0).links()).containsExactly(AddressText.parse(cable.address()));
            assertThat(held).hasSize(ITEMS);
            assertThat(held.subList(1, ITEMS)) // item 0 is the vehicle's home
                    .allSatisfy(item -> assertThat(item.isSameAs(mission().get(item.number())))
                            .isTrue());
            assertThat(base.setMode(id, "LOITER").join().inWords()).contains("accepts to change to LOITER");
            assertThat(base.links().get(0).lost()).isZero();
        }
    }

    @Test
    void portThatIsPulledOutIsNamedAndReadAgainOnceItIsBack() throws Exception {
        try (SmallBoat boat = new SmallBoat(7, 45.7, 10.72, 1);
                SerialCable cable = new SerialCable(folder.resolve("radio"), boat.address());
                MavlinkBase base = base(cable.address())) {
            VehicleId id = known(base);

            cable.pullOut();
            Await.until(
                    "the missing port is named",
                    () -> base.links().get(0).fault().orElse("").startsWith("there is no port "));
            assertThat(base.links().get(0).state()).isEqualTo(MavlinkLinkState.BROKEN);
            assertThat(base.links().get(0).fault().orElseThrow()).contains("plug the radio in");
            long before = base.links().get(0).messages();

            cable.plugIn();
            Await.until("it is heard again", () -> base.links().get(0).messages() > before);
            assertThat(base.links().get(0).fault()).isEmpty();
            assertThat(base.setMode(id, "HOLD").join().inWords()).contains("accepts to change to HOLD");
        }
    }

    @Test
    void portThatAnotherProgramHoldsIsNamed() throws Exception {
        try (SmallBoat boat = new SmallBoat(7, 45.7, 10.72, 1);
                SerialCable cable = new SerialCable(folder.resolve("radio"), boat.address());
                MavlinkBase first = base(cable.address())) {
            known(first);

            try (MavlinkBase second = base(cable.address())) {
                Await.until(
                        "the second is told",
                        () -> second.links().get(0).fault().isPresent());
                assertThat(second.links().get(0).fault().orElseThrow())
                        .contains("cannot be opened: another program may hold it");
            }
        }
    }

    @Test
    void fileThatIsNoPortIsNamed() throws Exception {
        Path file = Files.writeString(folder.resolve("notes.txt"), "no port");

        try (MavlinkBase base = base("mavlink:serial:" + file + ":57600")) {
            Await.until("it is said", () -> base.links().get(0).fault().isPresent());

            assertThat(base.links().get(0).fault())
                    .isEqualTo(Optional.of(
                            file + " cannot be opened: another program may hold it, or it is no serial port"));
        }
    }
}
