package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.RobotKind;
import org.sami.mavlink.testing.SmallBoat;

/** What a base says of vehicles that it does not command, and that it does not take them for connected. */
@Timeout(900)
class RefusedVehicleTest {
    @TempDir
    private Path folder;

    private SmallBoat boat;

    @BeforeEach
    void launch() throws Exception {
        boat = new SmallBoat(5, 45.7, 10.72, 1);
    }

    @AfterEach
    void end() throws Exception {
        boat.close();
    }

    /** In sessions of each kind of robots; as what was refused, or as what does not answer. */
    private void isSaid(GatewayWorld world, String words, boolean asRefused) {
        Await.until(
                words,
                GatewayWorld.WAIT_S,
                () -> world.links().stream()
                        .anyMatch(link -> link.lastEvent().contains(words) && link.refused() == asRefused));
        assertThat(RobotKind.values()).allMatch(robots -> robots.say(words).equals(words));
        assertThat(world.links()).allMatch(link -> link.boatId().isEmpty());
    }

    @Test
    void vehicleThatSpeaksTheFirstVersionOnlyIsNotConnectedAndToldWhatToSet() {
        boat.speakFirstVersion();
        try (GatewayWorld world = new GatewayWorld(folder)) {
            world.connect(boat.address());

            isSaid(world, "it speaks MAVLink 1 only; set the autopilot's port to MAVLink 2", true);
        }
    }

    @Test
    void planeIsRefusedWithWhatToGiveInItsPlace() {
        boat.reports().isPlane();
        try (GatewayWorld world = new GatewayWorld(folder)) {
            world.connect(boat.address());

            isSaid(
                    world,
                    "vehicle 5 is a plane, and here only surface boats and copters are commanded: give the address or"
                            + " number of one of these",
                    true);
        }
    }

    /** Refuses whatever comes, as web servers do, and closes. */
    private static void refuseAll(ServerSocket server) {
        try {
            while (true) {
                try (Socket socket = server.accept()) {
                    socket.getOutputStream()
                            .write("HTTP/1.1 400 Bad Request\r\n\r\n".getBytes(StandardCharsets.ISO_8859_1));
                }
            }
        } catch (IOException e) {
            // the test is over
        }
    }

    @Test
    void webServerIsNamedAtTheAddressOfAVehicle() throws Exception {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                GatewayWorld world = new GatewayWorld(folder)) {
            new Thread(() -> refuseAll(server)).start();
            world.connect("mavlink:tcp:127.0.0.1:" + server.getLocalPort());

            isSaid(world, "a web server answers there, and no vehicle: look at host and port", true);
        }
    }

    @Test
    void vehicleThatIsNotThereIsMissedBesideOneThatIs() {
        try (GatewayWorld world = new GatewayWorld(folder)) {
            world.connect(boat.address() + "/9");

            isSaid(world, "no vehicle 9 is heard there, only surface boat 5", false);
        }
    }

    @Test
    void vehicleThatIsHeardAndHasNotAnsweredYetIsNotSaidToBeMissing() {
        boat.faults().deaf(true);
        try (GatewayWorld world = new GatewayWorld(folder)) {
            world.connect(boat.address() + "/5");

            isSaid(
                    world,
                    "vehicle 5 is heard there, but has not yet answered what it is asked: it is linked once it has",
                    false);
        }
    }

    @Test
    void vehicleOfAnotherAutopilotIsRefusedByItsName() {
        boat.reports().steeredByPx4();
        try (GatewayWorld world = new GatewayWorld(folder)) {
            world.connect(boat.address());

            isSaid(world, "vehicle 5 has the autopilot PX4, and here only ArduPilot's vehicles", true);
        }
    }
}
