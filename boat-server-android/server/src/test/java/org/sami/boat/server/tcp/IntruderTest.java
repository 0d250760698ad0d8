package org.sami.boat.server.tcp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.Ack;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.Hello;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.security.Identity;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.Peer;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.link.security.TlsLinks;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.TappedWire;

/** Whoever gets between a base and its boat, or pretends to be the base: refused, told in words on the boat's console, counted, and nobody else notices. */
@Timeout(900)
class IntruderTest {
    private static final int PATIENCE_MS = 60_000;

    private final KeyRing boat = KeyRing.inMemory();
    private final KeyRing base = KeyRing.inMemory();
    private final List<AutoCloseable> open = new ArrayList<>();
    private TcpBench bench;

    @BeforeEach
    void open() throws IOException {
        bench = new TcpBench(settings -> settings, tcp -> tcp.withKeys(boat, new PairingResponder(boat)))
                .stopTime(); // nobody is lost where the machine is slow
        boat.add(new Peer(base.identity().fingerprint(), "base", Role.COMMANDER));
    }

    @AfterEach
    void close() throws Exception {
        for (AutoCloseable one : open) {
            one.close();
        }
        bench.close();
    }

    private Socket socket(int port) throws IOException {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
        open.add(socket);
        socket.setSoTimeout(PATIENCE_MS);
        return socket;
    }

    private Socket socket() throws IOException {
        return socket(bench.server.address().getPort());
    }

    /** A client over a protected link. */
    private static final class Speaker {
        private final SecureLink link;
        private final FrameReader frames;
        private long sequence;
        private String term = "";

        Speaker(Socket socket, Identity identity) throws IOException {
            link = TlsLinks.toPair(identity).connect(socket);
            frames = new FrameReader(new BufferedInputStream(link.in()), new LinkCodec());
        }

        void say(LinkMessage message) throws IOException {
            link.out().write(LinkCodec.STANDARD.encode(new Frame(sequence++, term, message)));
        }

        /** The next message of a kind; others are passed over. */
        <M extends LinkMessage> M hear(Class<M> kind) throws Exception {
            while (true) {
                Optional<byte[]> next = frames.next();
                LinkMessage message = LinkCodec.STANDARD
                        .decode(next.orElseThrow(() -> new IOException("closed")))
                        .message();
                if (message instanceof Welcome welcome) {
                    term = welcome.term();
                }
                if (kind.isInstance(message)) {
                    return kind.cast(message);
                }
            }
        }
    }

    private Speaker commander() throws Exception {
        Speaker commander = new Speaker(socket(), base.identity());
        commander.say(new Hello("boat1", "base", Role.COMMANDER, 1, "", "base.0", 1));
        assertThat(commander.hear(Welcome.class).role()).isEqualTo(Role.COMMANDER);
        return commander;
    }

    /** One connection was refused, for a reason in words, and the commander goes on. */
    private void assertRefused(Speaker commander, String id, String words) throws Exception {
        Await.until("it is counted", () -> bench.server.refusedConnections() == 1);
        Await.until("it is told", () -> bench.goodbyes.stream().anyMatch(why -> why.contains(words)));
        commander.say(new HoldPosition(id));
        assertThat(commander.hear(Ack.class).commandId()).isEqualTo(id);
        assertThat(bench.executed).containsExactly(id + " ack");
        assertThat(bench.failures).isEmpty();
    }

    @Test
    void baseThatIsNotPairedIsToldCountedAndNotHeard() throws Exception {
        Speaker commander = commander();
        Speaker stranger = new Speaker(socket(), Identity.generate());
        stranger.say(new HoldPosition("of a stranger"));
        stranger.say(new Hello("boat1", "base", Role.COMMANDER, 1, "", "base.0", 1));

        assertThat(stranger.hear(Goodbye.class).reason()).contains("not paired with boat1");

        assertRefused(commander, "after", "not paired with boat1");
    }

    @Test
    void whoeverShowsTheBasesCertificateWithoutItsKeyIsRefused() throws Exception {
        Speaker commander = commander();
        Identity pretended =
                new Identity(Identity.generate().key(), base.identity().certificate());

        assertThatThrownBy(() -> {
                    Speaker thief =
                            new Speaker(socket(), pretended); // the boat's verdict may come only with the answer
                    thief.say(new Hello("boat1", "base", Role.COMMANDER, 1, "", "base.0", 1));
                    thief.hear(Welcome.class);
                })
                .isInstanceOf(IOException.class);

        assertRefused(commander, "after", "no protected link");
    }

    /** The boat's own clock says how old the recording is. */
    @ParameterizedTest
    @ValueSource(longs = {0, 61_000, 24 * 3_600_000})
    void whatWasRecordedIsRefusedHoweverOldItIs(long ageMs) throws Exception {
        byte[] recorded;
        try (TappedWire wire = new TappedWire(bench.server.address(), TappedWire.UNCHANGED)) {
            Speaker speaker = new Speaker(socket(wire.port()), base.identity());
            speaker.say(new Hello("boat1", "base", Role.OBSERVER, 1, ""));
            speaker.hear(Welcome.class);
            recorded = wire.recorded();
        }
        Await.until("the recorded link has ended", () -> bench.server.clientCount() == 0);
        bench.passMs(ageMs);
        Speaker commander = commander();

        socket().getOutputStream().write(recorded);

        assertRefused(commander, "after", "no protected link");
    }

    /** The one in between makes a hello of TLS 1.3 look like one of 1.2. Both speak 1.2 as well, and the base sees that they were brought to it. */
    @Test
    void linkThatSomebodyInBetweenBringsToAnOlderVersionIsRefusedByBothSides() throws Exception {
        Speaker commander = commander();
        try (TappedWire wire = new TappedWire(bench.server.address(), TappedWire.WITHOUT_VERSIONS)) {

            assertThatThrownBy(() -> new Speaker(socket(wire.port()), base.identity()))
                    .hasMessageContaining("no protected link")
                    .hasMessageContaining("downgrade");

            assertThat(wire.changed()).isTrue();
            assertRefused(commander, "after", "no protected link");
        }
    }

    @Test
    void oneBitThatIsFlippedOnItsWayEndsTheLinkAndIsNoCommand() throws Exception {
        Speaker commander = commander();
        try (TappedWire wire = new TappedWire(bench.server.address(), TappedWire.UNCHANGED)) {
            Speaker bent = new Speaker(socket(wire.port()), base.identity());
            bent.say(new Hello("boat1", "bent", Role.OBSERVER, 1, ""));
            bent.hear(Welcome.class);
            wire.flipOneBit();
            bent.say(new HoldPosition("bent"));

            assertThatThrownBy(() -> bent.hear(Ack.class)).isInstanceOf(IOException.class);
        }
        commander.say(new HoldPosition("after"));
        assertThat(commander.hear(Ack.class).commandId()).isEqualTo("after");
        assertThat(bench.executed).containsExactly("after ack");
    }
}
