package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CompletionException;
import java.util.concurrent.RejectedExecutionException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.link.MavlinkLinkState;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.testing.SensorMessages;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.testing.SmallVehicle;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** A base and small vehicles on real sockets. */
@Timeout(900)
class MavlinkBaseTest {
    private static MavlinkBase base(String... addresses) {
        return new MavlinkBase(
                List.of(addresses).stream().map(AddressText::parse).toList(), ProcessClock::ms);
    }

    private static List<VehicleSnapshot> vehicles(MavlinkBase base) {
        return base.vehicles().join();
    }

    @Test
    void vehiclesOnTwoLinksAreKnownWithWhatTheyReport() throws Exception {
        try (SmallVehicle one = new SmallVehicle(1, 3, false);
                SmallVehicle two = new SmallVehicle(2, 3, false);
                MavlinkBase base = base(one.address(), two.address())) {
            Await.until(
                    "both are known",
                    () -> vehicles(base).size() == 2
                            && vehicles(base).stream()
                                    .allMatch(each ->
                                            each.located() && each.battery().isPresent()));

            VehicleSnapshot first = vehicles(base).get(0);
            assertThat(first.id()).isEqualTo(new VehicleId(1, 1));
            assertThat(first.kind()).isEqualTo(VehicleKind.BOAT);
            assertThat(first.mode()).isEqualTo("HOLD");
            assertThat(first.position().orElseThrow().speedMps()).isEqualTo(0.5);
            assertThat(first.links()).containsExactly(AddressText.parse(one.address()));
            Await.until(
                    "it has said something",
                    () -> !vehicles(base).get(0).texts().isEmpty());
        }
    }

    @Test
    void missionThatAVehicleHoldsIsRead() throws Exception {
        try (SmallVehicle vehicle = new SmallVehicle(9, 25, false);
                MavlinkBase base = base(vehicle.address())) {
            Await.until("it is known", () -> !vehicles(base).isEmpty());
            VehicleId id = vehicles(base).get(0).id();
            var mission = base.held(id, HeldKind.MISSION);
            var fence = base.held(id, HeldKind.FENCE);

            assertThat(mission.join()).hasSize(25);
            assertThat(mission.join()).extracting(MissionItem::commandName).containsOnly("nav waypoint");
            assertThat(fence.join()).isEmpty();
        }
    }

    @Test
    void vehicleThatIsNotThereIsNamedWhenItIsAsked() {
        try (MavlinkBase base = base("mavlink:udpout:127.0.0.1:9")) {
            var mission = base.held(new VehicleId(77, 1), HeldKind.MISSION);

            assertThatThrownBy(mission::join).hasMessageContaining("vehicle 77 does not answer");
        }
    }

    @Test
    void linkIsOpenedAgainWhenTheVehicleComesBack() throws Exception {
        SmallVehicle vehicle = new SmallVehicle(1, 0, false);
        int port =
                Integer.parseInt(vehicle.address().substring(vehicle.address().lastIndexOf(':') + 1));
        try (MavlinkBase base = base(vehicle.address())) {
            Await.until("it is known", () -> !vehicles(base).isEmpty());
            vehicle.close();
            Await.until("the link is broken", () -> base.links().get(0).state() == MavlinkLinkState.BROKEN);
            assertThat(base.links().get(0).fault()).isPresent();
            long before = base.links().get(0).messages();
            try (SmallVehicle again = new SmallVehicle(1, 0, false, port)) {
                Await.until("it is heard again", () -> base.links().get(0).messages() > before);
                assertThat(base.links().get(0).state()).isEqualTo(MavlinkLinkState.OPEN);
            }
        }
    }

    @Test
    void whatIsNoMavlinkIsSaid() throws Exception {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                MavlinkBase base = base("mavlink:tcp:127.0.0.1:" + server.getLocalPort());
                Socket socket = server.accept()) {
            byte[] noise = new byte[20_000];
            new SplittableRandom(5).nextBytes(noise);
            for (int i = 0; i < noise.length; i++) {
                noise[i] &= 0x7f; // no message begins with these
            }
            write(socket, noise);

            Await.until(
                    "it is said", () -> base.links().get(0).fault().orElse("").startsWith("what comes is no MAVLink"));
            assertThat(vehicles(base)).isEmpty();
        }
    }

    private static void write(Socket socket, byte[] bytes) throws IOException {
        OutputStream out = socket.getOutputStream();
        out.write(bytes);
        out.flush();
    }

    private static String faultAt(String answer, boolean closes) throws IOException {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                MavlinkBase base = base("mavlink:tcp:127.0.0.1:" + server.getLocalPort());
                Socket socket = server.accept()) {
            write(socket, answer.getBytes(StandardCharsets.ISO_8859_1));
            if (closes) {
                socket.close();
            }
            Await.until("it is said", () -> base.links().get(0).fault().isPresent());
            return base.links().get(0).fault().orElseThrow();
        }
    }

    @Test
    void whatAnswersInPlaceOfAVehicleIsNamedWithWhatToDo() throws Exception {
        String ssh = "an SSH server answers there, and no vehicle: look at host and port";

        assertThat(faultAt("SSH-2.0-OpenSSH_9.2\r\n", false)).startsWith(ssh);
        assertThat(faultAt("SSH-2.0-OpenSSH_9.2\r\n", true)).startsWith(ssh);
        assertThat(faultAt("HTTP/1.1 400 Bad Request\r\n\r\n", true))
                .startsWith("a web server answers there, and no vehicle: look at host and port");
        assertThat(faultAt("", true)).startsWith("what listens there closes the link without a word: look at");
        assertThat(faultAt("220 mail.local ESMTP\r\n", true))
                .startsWith("what answers there speaks no MAVLink and closes the link: look at");
    }

    @Test
    void webServerThatClosesIsNamedAlsoOnceTheLinkIsOpenAgain() throws Exception {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                MavlinkBase base = base("mavlink:tcp:127.0.0.1:" + server.getLocalPort())) {
            try (Socket socket = server.accept()) {
                write(socket, "HTTP/1.1 400 Bad Request\r\n\r\n".getBytes(StandardCharsets.ISO_8859_1));
                Await.until("it has come", () -> base.links().get(0).bytes() > 0);
            }
            try (Socket again = server.accept()) {
                Await.until("it is open again", () -> base.links().get(0).state() == MavlinkLinkState.OPEN);

                assertThat(base.links().get(0).fault())
                        .hasValueSatisfying(fault -> assertThat(fault).startsWith("a web server answers there"));
                assertThat(again.isConnected()).isTrue();
            }
        }
    }

    @Test
    void radioThatReportsItselfOnANetworkMakesItASlowLink() throws Exception {
        try (SmallBoat boat = new SmallBoat(3, 45.7, 10.72, 1);
                MavlinkBase base = base(boat.address())) {
            Await.until("it is known", () -> !vehicles(base).isEmpty());
            assertThat(vehicles(base).get(0).heardOn().get(0).slow()).isFalse();
            assertThat(base.plans().join().values())
                    .allSatisfy(plan -> assertThat(plan.filledPart()).isEmpty());

            boat.sends(SensorMessages.radio(180));

            Await.until(
                    "it is slow", () -> vehicles(base).get(0).heardOn().get(0).slow());
            assertThat(base.links().get(0).rssi()).contains(180);
            assertThat(base.plans().join().values())
                    .allSatisfy(plan -> assertThat(plan.bytesPerSecond()).hasValue(5_760));
        }
    }

    @Test
    void portThatIsNotThereIsNamedWithWhatToDo() {
        try (MavlinkBase base = base("mavlink:serial:/dev/ttyUSB9:57600")) {
            Await.until("it is said", () -> base.links().get(0).fault().isPresent());

            assertThat(base.links().get(0).fault().orElseThrow())
                    .startsWith("there is no port /dev/ttyUSB9: plug the radio in");
        }
    }

    @Test
    void vehicleThatSpeaksTheFirstVersionOnlyIsKnownAndSaid() throws Exception {
        try (SmallVehicle vehicle = new SmallVehicle(4, 0, true);
                MavlinkBase base = base(vehicle.address())) {
            Await.until("it is known", () -> !vehicles(base).isEmpty());

            assertThat(base.links().get(0).fault())
                    .hasValueSatisfying(fault -> assertThat(fault).contains("MAVLink 1 only"));
        }
    }

    @Test
    void randomBytesLeaveOtherLinksUntouched() throws Exception {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                SmallVehicle vehicle = new SmallVehicle(1, 5, false);
                MavlinkBase base = base("mavlink:tcp:127.0.0.1:" + server.getLocalPort(), vehicle.address());
                Socket socket = server.accept()) {
            byte[] noise = new byte[1_000_000];
            new SplittableRandom(11).nextBytes(noise);
            write(socket, noise);
            Await.until("it is all read", () -> base.links().get(0).bytes() > 900_000);
            Await.until(
                    "the vehicle is known",
                    () -> vehicles(base).stream().anyMatch(each -> each.id().equals(new VehicleId(1, 1))));

            assertThat(base.held(new VehicleId(1, 1), HeldKind.MISSION).join()).hasSize(5);
        }
    }

    private static byte[] heartbeat(int system) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        MavlinkConnection.create(InputStream.nullInputStream(), bytes)
                .send2(
                        system,
                        1,
                        Heartbeat.builder()
                                .type(MavType.MAV_TYPE_SURFACE_BOAT)
                                .autopilot(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA)
                                .systemStatus(MavState.MAV_STATE_STANDBY)
                                .mavlinkVersion(3)
                                .build());
        return bytes.toByteArray();
    }

    @Test
    void messagesThatCameTogetherWithOneThatHasAFaultAreHandled() throws Exception {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                MavlinkBase base = base("mavlink:tcp:127.0.0.1:" + server.getLocalPort())) {
            base.addListener(event -> {
                if (event instanceof VehicleEvent.Appeared appeared
                        && appeared.vehicle().equals(new VehicleId(1, 1))) {
                    throw new IllegalStateException("a fault of a listener");
                }
            });
            try (Socket socket = server.accept()) {
                ByteArrayOutputStream together = new ByteArrayOutputStream();
                together.write(heartbeat(1));
                together.write(heartbeat(2));
                write(socket, together.toByteArray());

                Await.until(
                        "the second one is known",
                        () -> vehicles(base).stream().anyMatch(each -> each.id().equals(new VehicleId(2, 1))));
            }
        }
    }

    @Test
    void closedBaseRejectsWhatItIsAskedWhileItsThreadGoesOnForOthers() {
        try (BaseThread shared = new BaseThread();
                MavlinkBase other = new MavlinkBase(List.of(), ProcessClock::ms, MavlinkBaseOptions.none(), shared)) {
            MavlinkBase closed = new MavlinkBase(List.of(), ProcessClock::ms, MavlinkBaseOptions.none(), shared);
            var before = closed.parameter(new VehicleId(1, 1), "SYSID_THISMAV");
            closed.close();
            closed.close();

            assertThatThrownBy(before::join).isInstanceOf(CompletionException.class);
            assertThatThrownBy(() -> closed.parameter(new VehicleId(1, 1), "SYSID_THISMAV"))
                    .isInstanceOf(RejectedExecutionException.class);
            assertThat(vehicles(other)).isEmpty();
        }
    }
}
