package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.link.MessageReader;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.VehicleId;

/** A vehicle on UDP of which a datagram comes twice; its messages are written by hand. */
@Timeout(120)
class RepeatedAnswerTest {
    private static final VehicleId ID = new VehicleId(3, 1);

    private final ByteArrayOutputStream written = new ByteArrayOutputStream();
    private final MavlinkConnection codec = MavlinkConnection.create(InputStream.nullInputStream(), written);

    /** The datagram of a message, with the vehicle's next number. */
    private byte[] datagram(Object message) throws IOException {
        codec.send2(ID.system(), ID.component(), message);
        byte[] datagram = written.toByteArray();
        written.reset();
        return datagram;
    }

    private byte[] request(int item) throws IOException {
        return datagram(MissionRequestInt.builder()
                .seq(item)
                .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
                .build());
    }

    private byte[] accepted() throws IOException {
        return datagram(MissionAck.builder()
                .type(MavMissionResult.MAV_MISSION_ACCEPTED)
                .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
                .build());
    }

    /** The vehicle's socket, and the base behind it. */
    private record Link(DatagramSocket socket, SocketAddress base) {
        void send(byte[] datagram) throws IOException {
            socket.send(new DatagramPacket(datagram, datagram.length, base));
        }

        /** Waits for the next message about the vehicle's mission. */
        Object next() throws IOException {
            Object message = receive(socket).message;
            while (!(message instanceof MissionCount) && !(message instanceof MissionItemInt)) {
                message = receive(socket).message;
            }
            return message;
        }

        /** Waits until the vehicle is to be sent so many items; items of before may come once more. */
        void untilCount(int items) throws IOException {
            Object message = next();
            while (message instanceof MissionItemInt || ((MissionCount) message).count() < items) {
                message = next();
            }
            assertThat(((MissionCount) message).count()).isEqualTo(items);
        }

        /** Waits for an item; what was sent before may come once more. */
        void untilItem(int number) throws IOException {
            Object message = next();
            while (!(message instanceof MissionItemInt item) || item.seq() != number) {
                message = next();
            }
        }
    }

    private record Received(Object message, SocketAddress from) {}

    private static Received receive(DatagramSocket socket) throws IOException {
        DatagramPacket packet = new DatagramPacket(new byte[512], 512);
        socket.receive(packet);
        MessageReader reader =
                new MessageReader(new ByteArrayInputStream(packet.getData(), 0, packet.getLength()), kind -> true);
        return new Received(reader.message(reader.next()), packet.getSocketAddress());
    }

    @Test
    void theNextStepWaitsForAnAnswerOfItsOwn() throws Exception {
        try (DatagramSocket socket = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
                MavlinkBase base = new MavlinkBase(
                        List.of(AddressText.parse("mavlink:udpout:127.0.0.1:" + socket.getLocalPort())),
                        ProcessClock::ms)) {
            Link link = new Link(socket, receive(socket).from); // its heartbeat
            link.send(datagram(Heartbeat.builder()
                    .type(MavType.MAV_TYPE_SURFACE_BOAT)
                    .autopilot(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA)
                    .systemStatus(MavState.MAV_STATE_STANDBY)
                    .mavlinkVersion(3)
                    .build()));
            Await.until("it is known", () -> !base.vehicles().join().isEmpty());
            CompletableFuture<List<MissionItem>> result =
                    base.replaceInSteps(ID, HeldKind.MISSION, List.of(points(1), points(2), points(3)));
            link.untilCount(1);
            link.send(request(0));
            link.untilItem(0);
            byte[] first = accepted();
            link.send(first);
            link.untilCount(2);
            link.send(request(0));
            link.untilItem(0);
            link.send(request(1));
            link.untilItem(1);

            link.send(first); // once more, later than the vehicle has sent other messages

            for (int more = 0; more < 3; more++) {
                assertThat(link.next()).as("sent again, as no answer came").isInstanceOf(MissionItemInt.class);
            }
            link.send(accepted());
            link.untilCount(3);
            assertThat(result).isNotDone();
        }
    }

    private static List<MissionItem> points(int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> MissionItem.waypoint(i, 45 + i * 1e-4, 10, 0, 0))
                .toList();
    }
}
