package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.BindException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.link.MavlinkLinkState;
import org.sami.mavlink.testing.SerialCable;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** An address that is corrected while its port is open, on real ports. */
@Timeout(300)
class ReplacedLinkTest {
    @TempDir
    private Path folder;

    private static MavlinkBase base(MavlinkAddress address) {
        return new MavlinkBase(List.of(address), ProcessClock::ms);
    }

    private static int freePort() throws IOException {
        try (DatagramSocket free = new DatagramSocket()) {
            return free.getLocalPort();
        }
    }

    private static void sayHeartbeat(DatagramSocket from, int port) {
        try {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            MavlinkConnection.create(InputStream.nullInputStream(), bytes)
                    .send2(
                            3,
                            1,
                            Heartbeat.builder()
                                    .type(MavType.MAV_TYPE_SURFACE_BOAT)
                                    .autopilot(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA)
                                    .systemStatus(MavState.MAV_STATE_STANDBY)
                                    .mavlinkVersion(3)
                                    .build());
            from.send(new DatagramPacket(bytes.toByteArray(), bytes.size(), InetAddress.getLoopbackAddress(), port));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void untilHeard(MavlinkBase base, MavlinkAddress address, DatagramSocket vehicle, int port) {
        Await.until("it is heard on " + address, () -> {
            sayHeartbeat(vehicle, port);
            List<MavlinkLinkReport> links = base.links();
            return links.size() == 1
                    && links.get(0).address().equals(address)
                    && links.get(0).messages() > 0;
        });
    }

    @Test
    void portThatListensIsOpenedAnewWithAnotherSpeedAndItsVehicleIsHeardThere() throws Exception {
        int port = freePort();
        MavlinkAddress first = AddressText.parse("mavlink:udp:" + port);
        MavlinkAddress corrected = AddressText.parse("mavlink:udp:" + port + "?baud=57600");
        try (DatagramSocket vehicle = new DatagramSocket();
                MavlinkBase base = base(first)) {
            untilHeard(base, first, vehicle, port);

            base.open(corrected);
            untilHeard(base, corrected, vehicle, port);

            assertThat(base.links().get(0).state()).isEqualTo(MavlinkLinkState.OPEN);
            assertThat(base.vehicles().join())
                    .singleElement()
                    .satisfies(known -> assertThat(known.links()).containsExactly(corrected))
                    .satisfies(known -> assertThat(known.unsettled()).isEmpty());

            base.open(first);
            untilHeard(base, first, vehicle, port);
        }
    }

    @Test
    void portThatIsClosedIsFreeForOthersAndCanBeOpenedAgain() throws Exception {
        int port = freePort();
        MavlinkAddress address = AddressText.parse("mavlink:udp:" + port);
        try (DatagramSocket vehicle = new DatagramSocket();
                MavlinkBase base = base(address)) {
            Await.until("it is open", () -> base.links().get(0).state() == MavlinkLinkState.OPEN);

            base.close(address);
            assertThat(base.links()).isEmpty();
            Await.until("the port is free", () -> isFree(port));

            base.open(address);
            untilHeard(base, address, vehicle, port);
        }
    }

    private static boolean isFree(int port) {
        try (DatagramSocket other = new DatagramSocket(port)) {
            return other.isBound();
        } catch (BindException e) {
            return false;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    @EnabledOnOs(value = OS.LINUX, disabledReason = "pseudo terminals are opened as Linux does it")
    void serialPortIsOpenedAnewWithACorrectedBaudRate() throws Exception {
        try (SmallBoat boat = new SmallBoat(7, 45.7, 10.72, 1);
                SerialCable cable = new SerialCable(folder.resolve("radio"), boat.address());
                MavlinkBase base = base(AddressText.parse(cable.address()))) {
            Await.until("it is known", () -> base.vehicles().join().stream().anyMatch(VehicleSnapshot::located));
            MavlinkAddress corrected = AddressText.parse(cable.address().replace(":57600", ":115200"));

            base.open(corrected);

            Await.until("it is heard there", () -> base.links().get(0).messages() > 0);
            assertThat(base.links()).extracting(MavlinkLinkReport::address).containsExactly(corrected);
            assertThat(base.setMode(new VehicleId(7, 1), "LOITER").join().inWords())
                    .contains("accepts to change to LOITER");
            assertThat(base.vehicles().join().get(0).links()).containsExactly(corrected);
        }
    }
}
