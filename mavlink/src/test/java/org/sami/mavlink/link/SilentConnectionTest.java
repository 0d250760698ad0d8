package org.sami.mavlink.link;

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
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.address.AddressText;

/** Connections whose other end says nothing more, and does not close them, as where a cable is pulled. */
@Timeout(120)
class SilentConnectionTest {
    private static final Duration SHORT = Duration.ofMillis(100);
    private static final int LONGEST_MS = 60_000; // a test that waits longer has failed
    private static final LinkEnd BOAT = new LinkEnd(7, 1, 0, Optional.empty());

    private static ServerSocket server() throws IOException {
        ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        server.setSoTimeout(LONGEST_MS);
        return server;
    }

    private static MavlinkLink link(ServerSocket to, LinkEnd end, MavlinkLinkListener listener) {
        MavlinkLink link = new MavlinkLink(
                AddressText.parse("mavlink:tcp:127.0.0.1:" + to.getLocalPort()), listener, end, kind -> true, SHORT);
        link.start();
        return link;
    }

    private static byte[] heartbeat() throws IOException {
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
        return bytes.toByteArray();
    }

    private static void say(Socket client, byte[] bytes) throws IOException {
        client.getOutputStream().write(bytes);
        client.getOutputStream().flush();
    }

    /** A vehicle speaks once on each of some connections and then no more, so that each of them but the last is given up. */
    private static void speakOnceOnEachOf(int connections, ServerSocket server) throws IOException {
        for (int i = 0; i < connections; i++) {
            try (Socket client = server.accept()) {
                client.setSoTimeout(LONGEST_MS);
                say(client, heartbeat());
                while (client.getInputStream().read() >= 0) {
                    // until the link closes it
                }
            }
        }
    }

    @Test
    void aConnectionOnWhichAVehicleFallsSilentIsOpenedAgainAndSaysWhyUntilItIsHeard() throws Exception {
        CountDownLatch opened = new CountDownLatch(1);
        BlockingQueue<Optional<String>> faults = new LinkedBlockingQueue<>();
        AtomicReference<MavlinkLink> self = new AtomicReference<>();
        try (ServerSocket server = server();
                MavlinkLink link = link(server, LinkEnd.ground(), (from, messages) -> {
                    if (opened.getCount() == 0) {
                        faults.add(self.get().report().fault());
                    }
                })) {
            self.set(link);
            speakOnceOnEachOf(1, server);
            try (Socket again = server.accept()) {
                Await.until("it is open again", () -> link.report().state() == MavlinkLinkState.OPEN);
                assertThat(link.report().fault())
                        .hasValueSatisfying(why -> assertThat(why).startsWith("nothing has come for"));

                opened.countDown();
                say(again, heartbeat());
                assertThat(faults.take()).isEmpty();
            }
        }
    }

    private static void assertIsKept(LinkEnd end, byte[] said) throws IOException {
        try (ServerSocket server = server();
                ServerSocket other = server();
                MavlinkLink link = link(server, end, (from, messages) -> {});
                MavlinkLink silent = link(other, LinkEnd.ground(), (from, messages) -> {});
                Socket client = server.accept()) {
            say(client, said);
            Await.until("it has come", () -> link.report().bytes() == said.length);

            speakOnceOnEachOf(4, other); // takes longer than the connection may be silent

            assertThat(silent.report().messages()).isEqualTo(4);
            assertThat(link.report().state()).isEqualTo(MavlinkLinkState.OPEN);
            server.setSoTimeout(1);
            assertThatThrownBy(server::accept).isInstanceOf(SocketTimeoutException.class);
        }
    }

    @Test
    void aConnectionOnWhichNothingCameIsKept() throws Exception {
        assertIsKept(LinkEnd.ground(), new byte[0]);
    }

    @Test
    void aConnectionOnWhichNoMavlinkCameIsKept() throws Exception {
        assertIsKept(LinkEnd.ground(), "SSH-2.0-OpenSSH_9.2\r\n".getBytes(StandardCharsets.ISO_8859_1));
    }

    @Test
    void aBoatKeepsTheConnectionOfAStationThatListensOnly() throws Exception {
        assertIsKept(BOAT, heartbeat());
    }
}
