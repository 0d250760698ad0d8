package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.sim.boat.TcpTestFleet.Base;

/** Of a boat or an address that is taken out of the fleet neither a thread nor a socket is left, on neither side. */
@Timeout(900)
class GivenUpLinkTest {
    private static final String CLIENT = "giving-up";

    @TempDir
    private Path logs;

    private TcpTestFleet fleet;

    @BeforeEach
    void open() {
        fleet = new TcpTestFleet(logs);
    }

    @AfterEach
    void close() throws Exception {
        fleet.close();
    }

    @Test
    void boatThatIsRemovedSeesItsConnectionClosedAndNoThreadIsLeft() throws Exception {
        List<String> closed = new CopyOnWriteArrayList<>();
        TcpServerListener listener = new TcpServerListener() {
            @Override
            public void closed(String client, String why) {
                closed.add(client);
            }
        };
        try (BoatOnTcp boat = new BoatOnTcp(
                BoatSettings.of("gaby", TcpTestFleet.port(0), TcpTestFleet.PIER, 1),
                new SteadyClock(ProcessClock::ms),
                listener)) {
            Base base = fleet.base(CLIENT + "-linked");
            base.connect(boat.address(), "gaby");

            assertThat(base.tcp.remove("gaby").join()).isTrue();

            Await.until("the boat sees the end of the connection", () -> !closed.isEmpty());
            Await.until("no thread is left", () -> Await.threads(CLIENT + "-linked-to-") == 0);
            assertThat(base.links()).isEmpty();
        }
    }

    @Test
    void addressThatNeverAnswersIsClosedAtOnceWhenItIsGivenUp() throws Exception {
        try (ServerSocket silent = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            Base base = fleet.base(CLIENT + "-silent");
            InetSocketAddress address = TcpTestFleet.port(silent.getLocalPort());
            base.tcp.connect(address);
            try (Socket accepted = silent.accept()) {
                assertThat(base.tcp.disconnect(address).join()).isTrue();

                assertThat(hasEnded(accepted)).isTrue();
            }
            Await.until("no thread is left", () -> Await.threads(CLIENT + "-silent-to-") == 0);
            assertThat(base.links()).isEmpty();
        }
    }

    @Test
    void boatWhoseLinkIsLostIsNotTriedAnyLongerOnceItIsRemoved() throws Exception {
        BoatOnTcp boat = fleet.boat("gaby");
        Base base = fleet.base(CLIENT + "-lost");
        base.connect(boat.address(), "gaby");
        boat.close();
        Await.until("the link is lost", () -> base.count("gaby LOST") == 1);

        assertThat(base.tcp.remove("gaby").join()).isTrue();

        Await.until("no thread is left", () -> Await.threads(CLIENT + "-lost-to-") == 0);
        assertThat(base.links()).isEmpty();
    }

    /** Reads what the base has said, up to the end of the connection. */
    private static boolean hasEnded(Socket socket) throws IOException {
        try {
            while (socket.getInputStream().read() >= 0) {
                // its hello
            }
            return true;
        } catch (SocketException reset) {
            return true;
        }
    }
}
