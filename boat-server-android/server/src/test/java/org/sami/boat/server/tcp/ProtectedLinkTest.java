package org.sami.boat.server.tcp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.Ack;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.Hello;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.Pair;
import org.sami.boat.link.Paired;
import org.sami.boat.link.Role;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.WithdrawKeys;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.LinkSecurity;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.link.security.Peer;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.link.security.TlsLinks;
import org.sami.boat.server.testing.Await;

/** A boat with keys obeys only whom it knows, and says so to all others; whoever tries to get around that disturbs nobody. */
@Timeout(900)
class ProtectedLinkTest {
    private static final int FUZZED = Integer.getInteger("sami.fuzz.handshakes", 300);

    private final KeyRing boat = KeyRing.inMemory();
    private final KeyRing base = KeyRing.inMemory();
    private final PairingResponder responder = new PairingResponder(boat);
    private final List<AutoCloseable> open = new ArrayList<>();
    private TcpBench bench;

    @BeforeEach
    void open() throws IOException {
        bench = new TcpBench(boat -> boat, tcp -> tcp.withKeys(boat, responder).withPatience(60_000, 600_000))
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

    private Socket socket() throws IOException {
        Socket socket = new Socket(
                InetAddress.getLoopbackAddress(), bench.server.address().getPort());
        socket.setSoTimeout(60_000);
        open.add(socket);
        return socket;
    }

    /** A client with some key, which takes any boat. */
    private final class Linked {
        private final SecureLink link;
        private final FrameReader frames;
        private long sequence;
        private String term = "";

        Linked(KeyRing keys) throws IOException {
            this(TlsLinks.toPair(keys.identity()));
        }

        Linked(LinkSecurity security) throws IOException {
            link = security.connect(socket());
            frames = new FrameReader(new BufferedInputStream(link.in()), new LinkCodec());
        }

        void say(LinkMessage message) throws IOException {
            link.out().write(LinkCodec.STANDARD.encode(new Frame(sequence++, term, message)));
        }

        /** The next message of a kind; others are passed over. */
        <M extends LinkMessage> M hear(Class<M> kind) throws Exception {
            while (true) {
                LinkMessage message = LinkCodec.STANDARD
                        .decode(frames.next().orElseThrow(() -> new IOException("closed")))
                        .message();
                if (message instanceof Welcome welcome) {
                    term = welcome.term();
                }
                if (kind.isInstance(message)) {
                    return kind.cast(message);
                }
            }
        }

        Welcome greet(String name) throws Exception {
            say(new Hello("boat1", name, Role.COMMANDER, 1, "", name + ".0", 1));
            return hear(Welcome.class);
        }
    }

    private void assertUntouched(Linked commander) throws Exception {
        String id = "h" + System.nanoTime();
        commander.say(new HoldPosition(id));
        assertThat(commander.hear(Ack.class).commandId()).isEqualTo(id);
        assertThat(bench.failures).isEmpty();
    }

    private void awaitTold(String words) {
        Await.until(
                "the console says why",
                () -> bench.goodbyes.stream()
                        .anyMatch(why -> why.startsWith("no protected link") && why.contains(words)));
    }

    @Test
    void pairedBaseCommandsOverTheNewestVersion() throws Exception {
        Linked commander = new Linked(TlsLinks.of(trusting()));

        assertThat(commander.greet("base").role()).isEqualTo(Role.COMMANDER);
        assertUntouched(commander);
        assertThat(commander.link.peer()).contains(boat.identity().fingerprint());
    }

    private KeyRing trusting() throws IOException {
        base.add(new Peer(boat.identity().fingerprint(), "boat1", Role.OBSERVER));
        return base;
    }

    @Test
    void strangerIsToldWhoTheBoatIsAndNothingElse() throws Exception {
        Linked stranger = new Linked(KeyRing.inMemory());
        stranger.say(new FleetStop("s"));
        stranger.say(new TakeCommand("t"));
        stranger.say(new StopMotors("m"));
        stranger.say(new Hello("", "stranger", Role.COMMANDER, 50, ""));

        Goodbye told = stranger.hear(Goodbye.class);

        assertThat(told.boatId()).isEqualTo("boat1");
        assertThat(told.reason()).contains("not paired with boat1");
        assertThat(bench.executed).isEmpty();
        assertThatThrownBy(() -> stranger.hear(LinkMessage.class)).isInstanceOf(IOException.class);
    }

    @Test
    void baseDoesNotGoOnWithABoatWhoseKeyIsNotPinned() throws Exception {
        assertThatThrownBy(() -> new Linked(TlsLinks.of(base)))
                .hasMessageContaining(boat.identity().fingerprint().shortText())
                .hasMessageContaining("is not paired with this base");
    }

    @Test
    void keyThatMayOnlyObserveObservesAndStops() throws Exception {
        KeyRing watcher = KeyRing.inMemory();
        boat.add(new Peer(watcher.identity().fingerprint(), "watcher", Role.OBSERVER));
        Linked linked = new Linked(watcher);

        assertThat(linked.greet("watcher").role()).isEqualTo(Role.OBSERVER);
        linked.say(new TakeCommand("t", "watcher.0", 5));
        assertThat(linked.hear(Nack.class).detail()).contains("may only observe");
        linked.say(new FleetStop("s"));
        assertThat(linked.hear(Ack.class).commandId()).isEqualTo("s");
    }

    @Test
    void strangerIsPairedWithTheWordsAndCommandsOverTheSameLink() throws Exception {
        PairingSecret words = responder.open(Role.COMMANDER, 0);
        KeyRing laptop = KeyRing.inMemory();
        Linked linked = new Linked(laptop);
        linked.say(new Pair(
                "laptop",
                words.proofOfBase(
                        laptop.identity().fingerprint(), linked.link.peer().get())));

        Paired paired = linked.hear(Paired.class);

        assertThat(paired.proof())
                .isEqualTo(words.proofOfBoat(
                        laptop.identity().fingerprint(), boat.identity().fingerprint()));
        assertThat(linked.greet("laptop").role()).isEqualTo(Role.COMMANDER);
    }

    @Test
    void withdrawnKeyLosesItsLinkAtOnceAndIsToldWhyWhenItComesBack() throws Exception {
        KeyRing lost = KeyRing.inMemory();
        boat.add(new Peer(lost.identity().fingerprint(), "lost laptop", Role.COMMANDER));
        Linked thief = new Linked(lost);
        thief.greet("thief");
        Linked commander = new Linked(base);
        commander.say(new Hello("boat1", "base", Role.OBSERVER, 1, "", "base.0", 2));
        long newest = commander.hear(Welcome.class).epoch().orElseThrow().number();
        commander.say(new TakeCommand("t", "base.0", newest + 1));
        commander.hear(Ack.class);

        commander.say(new WithdrawKeys(
                "w",
                List.of(
                        lost.identity().fingerprint().toString(),
                        base.identity().fingerprint().toString())));

        assertThat(commander.hear(Ack.class).commandId()).isEqualTo("w");
        assertThat(thief.hear(Goodbye.class).reason()).contains("withdrawn");
        Linked again = new Linked(lost);
        again.say(new Hello("", "thief", Role.COMMANDER, 1, ""));
        assertThat(again.hear(Goodbye.class).reason()).contains("key was withdrawn from boat1");
        assertUntouched(commander);
    }

    @Test
    void whoeverSpeaksPlainIsRefusedToldOnTheBoatAndCounted() throws Exception {
        Linked commander = new Linked(base);
        commander.greet("base");
        Socket plain = socket();
        plain.getOutputStream().write(LinkCodec.STANDARD.encode(0, new Hello("", "x", Role.COMMANDER, 1, "")));

        Await.until("it is counted", () -> bench.server.refusedConnections() == 1);
        awaitTold("it speaks plain");
        assertUntouched(commander);
    }

    @ParameterizedTest
    @ValueSource(strings = {"TLSv1", "TLSv1.1"})
    void whoeverOffersOnlyAnOldVersionIsRefusedAndCounted(String version) throws Exception {
        // what a client of that version says first, as the machine's own TLS no longer does
        byte minor = (byte) (version.equals("TLSv1") ? 1 : 2);
        Socket old = socket();
        old.getOutputStream().write(oldClientHello(minor));

        InputStream in = old.getInputStream();
        assertThat(in.read()).as("an alert").isEqualTo(0x15);
        Await.until("it is counted", () -> bench.server.refusedConnections() == 1);
        awaitTold(version);
    }

    private static byte[] oldClientHello(byte minor) {
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        body.write(3);
        body.write(minor);
        body.writeBytes(new byte[32]);
        body.writeBytes(new byte[] {0, 0, 4, (byte) 0xc0, 0x0a, 0x00, 0x35, 1, 0});
        byte[] hello = body.toByteArray();
        ByteArrayOutputStream record = new ByteArrayOutputStream();
        record.writeBytes(new byte[] {0x16, 3, 1, 0, (byte) (hello.length + 4), 1, 0, 0, (byte) hello.length});
        record.writeBytes(hello);
        return record.toByteArray();
    }

    @Test
    void baseDoesNotSpeakPlainWithWhoeverStripsTheProtection() throws Exception {
        try (ServerSocket stripper = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), stripper.getLocalPort());
                Socket other = stripper.accept()) {
            socket.setSoTimeout(60_000);
            other.getOutputStream()
                    .write(LinkCodec.STANDARD.encode(0, new Welcome("boat1", "boot", Role.COMMANDER, "")));

            assertThatThrownBy(() -> TlsLinks.of(trusting()).connect(socket)).hasMessageContaining("it speaks plain");
        }
    }

    @Test
    @Timeout(3600) // a hundred thousand take half an hour on a busy machine
    void handshakesOfNoiseLeaveOthersUntouched() throws Exception {
        Linked commander = new Linked(base);
        commander.greet("base");
        Random random = new Random(34);
        byte[] start = oldClientHello((byte) 3);
        for (int i = 0; i < FUZZED; i++) {
            byte[] noise = start.clone();
            for (int flips = random.nextInt(6); flips >= 0; flips--) {
                noise[random.nextInt(noise.length)] = (byte) random.nextInt(256);
            }
            try (Socket socket = new Socket(
                    InetAddress.getLoopbackAddress(), bench.server.address().getPort())) {
                socket.getOutputStream().write(noise, 0, 1 + random.nextInt(noise.length));
                socket.getOutputStream().write("\r\n".getBytes(StandardCharsets.US_ASCII));
            }
            if (i % 50 == 0) {
                assertUntouched(commander);
            }
        }

        assertUntouched(commander);
        Await.untilStill("connections that are refused", 5, () -> (int) bench.server.refusedConnections());
        assertThat(bench.server.refusedConnections()).isEqualTo(FUZZED);
        Await.until("only the commander is left", () -> bench.server.clientCount() == 1);
    }
}
