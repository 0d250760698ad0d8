package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.BindException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.proxy.gateway.GatewayLink;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.protocol.Priority;

/** Addresses of one UDP port that differ in the speed, given one after the other, as who corrects an address does. */
@Timeout(300)
class CorrectedAddressTest {
    @TempDir
    private Path folder;

    private final AtomicLong passedMs = new AtomicLong(); // beside the real time
    private MavlinkGateway gateway;
    private int port;

    @BeforeEach
    void begin() throws IOException {
        try (DatagramSocket free = new DatagramSocket()) {
            port = free.getLocalPort();
        }
        gateway = new MavlinkGateway(
                () -> ProcessClock.ms() + passedMs.get(), new VehicleFiles(folder), Optional.empty());
    }

    @AfterEach
    void end() {
        gateway.close();
    }

    private Asked ask(String text) {
        Asked asked = new Asked();
        gateway.connect(BoatAddress.parse(text).toSocketAddress(), asked);
        return asked;
    }

    private boolean isFree() {
        try (DatagramSocket other = new DatagramSocket(port)) {
            return other.isBound();
        } catch (BindException e) {
            return false;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void vehicleIsLinkedAtTheCorrectedAddressAndTheFirstOneLeadsToIt() throws Exception {
        Asked first = ask("mavlink:udp:" + port + "/5");
        Await.until("nobody was heard there", () -> !first.ended.isEmpty());
        try (SmallBoat boat = new SmallBoat(5, 45.7, 10.72, 1);
                UdpBridge bridge = new UdpBridge(boat.address(), port)) {
            Asked corrected = ask("mavlink:udp:" + port + "?baud=57600/5");
            Await.until("it is linked", () -> corrected.opened);
            passedMs.addAndGet(9_000);

            Asked again = ask("mavlink:udp:" + port + "/5"); // as a session does with each address
            Await.until("it leads there", () -> !again.found.isEmpty());

            assertThat(bridge.isOpen()).isTrue();
            assertThat(again.found)
                    .containsExactly(BoatAddress.parse("mavlink:udp:" + port + "?baud=57600/5")
                            .toSocketAddress());
            assertThat(corrected.ended).isEmpty();
        }
    }

    @Test
    void portOfAnAddressThatWasGivenUpIsFree() {
        Asked asked = ask("mavlink:udp:" + port + "/5");
        Await.until("nobody was heard there", () -> !asked.ended.isEmpty());
        assertThat(isFree()).isFalse(); // it may be asked for again soon

        passedMs.addAndGet(16_000);

        Await.until("the port is free", this::isFree);
    }

    /** An attempt at a link, and what became of it. */
    private static final class Asked implements GatewayLink.Listener {
        private final List<String> ended = new CopyOnWriteArrayList<>();
        private final List<InetSocketAddress> found = new CopyOnWriteArrayList<>();
        private volatile boolean opened;

        @Override
        public void opened() {
            opened = true;
        }

        @Override
        public void arrived(byte[] frame) {
            // nothing is asked for
        }

        @Override
        public void said(Priority priority, String text) {
            // what the vehicle says is no matter
        }

        @Override
        public void closed(String why) {
            ended.add(why);
        }

        @Override
        public void found(InetSocketAddress vehicle) {
            found.add(vehicle);
        }
    }

    /** Has a vehicle that listens on TCP send to a UDP port, as a router does. */
    private static final class UdpBridge implements AutoCloseable {
        private static final int AT_ONCE = 1_024;

        private final Socket vehicle;
        private final DatagramSocket base = new DatagramSocket();

        UdpBridge(String vehicleAddress, int port) throws IOException {
            int from = Integer.parseInt(vehicleAddress.substring(vehicleAddress.lastIndexOf(':') + 1));
            vehicle = new Socket(InetAddress.getLoopbackAddress(), from);
            begin(() -> {
                byte[] bytes = new byte[AT_ONCE];
                for (int read = vehicle.getInputStream().read(bytes);
                        read >= 0;
                        read = vehicle.getInputStream().read(bytes)) {
                    base.send(new DatagramPacket(bytes, read, InetAddress.getLoopbackAddress(), port));
                }
            });
            begin(() -> {
                while (true) {
                    DatagramPacket packet = new DatagramPacket(new byte[AT_ONCE], AT_ONCE);
                    base.receive(packet);
                    vehicle.getOutputStream().write(packet.getData(), 0, packet.getLength());
                }
            });
        }

        private interface Passing {
            void run() throws IOException;
        }

        private static void begin(Passing work) {
            Thread thread = new Thread(
                    () -> {
                        try {
                            work.run();
                        } catch (IOException e) {
                            // one of the ends is closed
                        }
                    },
                    "udp bridge");
            thread.setDaemon(true);
            thread.start();
        }

        boolean isOpen() {
            return !base.isClosed();
        }

        @Override
        public void close() throws IOException {
            base.close();
            vehicle.close();
        }
    }
}
