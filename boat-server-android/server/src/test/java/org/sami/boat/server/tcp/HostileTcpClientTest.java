package org.sami.boat.server.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.tcp.TcpBench.Client;

/** Streams that are cut, bent, doubled or never were frames: the boat stays whole, and serves the next client. */
@Timeout(60)
class HostileTcpClientTest {
    private static final List<Waypoint> OLD = List.of(new Waypoint(45.1, 10, 1));
    private static final List<Waypoint> NEW = List.of(new Waypoint(45.2, 10, 1), new Waypoint(45.3, 10, 1));

    private final LinkCodec codec = new LinkCodec();
    private TcpBench bench;

    @BeforeEach
    void open() throws IOException {
        bench = new TcpBench();
    }

    @AfterEach
    void close() throws IOException {
        bench.close();
        assertThat(bench.failures).isEmpty();
    }

    private static List<LinkMessage> commands() {
        return List.of(
                new UploadWaypoints("u", "l", NEW),
                new ReadBack("r"),
                new StartWaypoints("s", "l", 0),
                new HoldPosition("h"),
                new StopMotors("x"),
                new FleetStop("f"));
    }

    /** A commander in a boat that may still have to learn that its last one has gone. */
    private Client commander() throws Exception {
        Await.until("the last client is gone", 10, () -> bench.server.clientCount() == 0);
        return bench.greet("base", Role.COMMANDER, 10);
    }

    @Test
    void noPrefixOfAMessageIsExecuted() throws Exception {
        int cuts = 0;
        for (LinkMessage message : commands()) {
            byte[] frame = codec.encode(7, message);
            for (int length = 0; length < frame.length; length++) {
                try (Client client = commander()) {
                    client.send(Arrays.copyOf(frame, length));
                }
                cuts++;
            }
        }

        assertThat(cuts).isGreaterThan(300);
        assertThat(bench.executed).isEmpty();
        assertThat(commander().await(Telemetry.class).mode())
                .as("what is set for a lost link")
                .isEqualTo(BoatMode.HOLD);
    }

    @Test
    void cutUploadLeavesTheWholeOldListAndAWholeOneTheNew() throws Exception {
        try (Client client = commander()) {
            client.say(new UploadWaypoints("u0", "old", OLD));
            client.await(Ack.class);
        }
        byte[] frame = codec.encode(7, new UploadWaypoints("u1", "new", NEW));
        for (int length = 1; length <= frame.length; length++) {
            try (Client client = commander()) {
                client.send(Arrays.copyOf(frame, length));
                client.socket.shutdownOutput();
                client.isClosedByTheBoat();
            }
            try (Client client = commander()) {
                client.say(new ReadBack("r" + length));
                HeldWaypoints held = client.await(HeldWaypoints.class);
                boolean whole = length == frame.length;
                assertThat(held.listId()).isEqualTo(whole ? "new" : "old");
                assertThat(held.waypoints()).isEqualTo(whole ? NEW : OLD);
            }
        }
    }

    @Test
    void flippedBitsAreRefusedOrDropTheClient() throws Exception {
        SplittableRandom random = new SplittableRandom(61);
        for (int round = 0; round < 300; round++) {
            List<LinkMessage> commands = commands();
            byte[] frame = codec.encode(7, commands.get(random.nextInt(commands.size() - 1))); // no latched stop
            frame[random.nextInt(frame.length)] ^= (byte) (1 << random.nextInt(8));
            try (Client client = commander()) {
                client.send(frame);
                client.socket.shutdownOutput();
                assertThat(client.isClosedByTheBoat()).isTrue();
            }
        }

        assertThat(commander().await(Telemetry.class).latDeg()).isEqualTo(45);
    }

    @Test
    void twoMegabytesOfNoiseDropTheClientAndNobodyElse() throws Exception {
        Client other = bench.greet("other", Role.OBSERVER, 20);
        SplittableRandom random = new SplittableRandom(62);
        byte[] noise = new byte[2 << 20];
        for (int i = 0; i < noise.length; i++) {
            noise[i] = (byte) random.nextInt();
        }
        Client client = bench.connect();
        try {
            client.send(noise);
        } catch (IOException e) {
            assertThat(e).hasMessageMatching("(?i).*(broken pipe|reset).*"); // dropped before the end of it
        }

        assertThat(client.isClosedByTheBoat()).isTrue();
        other.await(Telemetry.class);
        assertThat(bench.executed).isEmpty();
    }

    @Test
    void declaredLengthOfTwoGigabytesDropsTheClient() throws Exception {
        for (int declared : new int[] {Integer.MAX_VALUE, Integer.MIN_VALUE, -1, 0, LinkCodec.DEFAULT_MAX_BYTES + 1}) {
            Client client = bench.greet("base", Role.OBSERVER, 1);
            client.send(ByteBuffer.allocate(4).putInt(declared).array());

            assertThat(client.isClosedByTheBoat()).as("declared %d", declared).isTrue();
        }
    }

    @Test
    void unreadableBodiesAreRefusedByNameAndTheClientStays() throws Exception {
        Client client = commander();
        String nan = "{\"type\":\"upload\",\"seq\":1,\"command\":\"c1\",\"list\":\"l\",\"waypoints\":[[NaN,1,1]]}";
        String far = "{\"type\":\"upload\",\"seq\":2,\"command\":\"c2\",\"list\":\"l\",\"waypoints\":[[99,1,1]]}";
        client.send(frame(nan.getBytes(java.nio.charset.StandardCharsets.UTF_8)));
        assertThat(client.await(Nack.class).reason()).isEqualTo(NackReason.MALFORMED);
        client.send(frame(far.getBytes(java.nio.charset.StandardCharsets.UTF_8)));
        assertThat(client.await(Nack.class).commandId()).isEqualTo("c2");
        client.send(frame(new byte[] {'{', '"', (byte) 0xc3, '(', '"', '}'}));
        assertThat(client.await(Nack.class).reason()).isEqualTo(NackReason.MALFORMED);

        client.say(new StopMotors("s"));
        assertThat(client.await(Ack.class).commandId()).isEqualTo("s");
        assertThat(bench.executed).containsExactly("s ack");
    }

    @Test
    void everythingTenTimesOverIsExecutedOnceAndAnsweredEachTime() throws Exception {
        Client client = commander();
        List<byte[]> frames = new ArrayList<>();
        List<LinkMessage> commands = commands();
        for (int i = 0; i < commands.size(); i++) {
            frames.add(codec.encode(i + 1, commands.get(i)));
        }
        for (byte[] frame : frames) {
            for (int i = 0; i < 10; i++) {
                client.send(frame);
            }
        }
        for (int i = 0; i < 50; i++) { // all but the read-backs
            client.await(Ack.class);
        }

        assertThat(bench.executed).containsExactly("u ack", "s ack", "h ack", "x ack", "f ack");
    }

    @Test
    void motionThatComesAfterALaterCommandIsRefused() throws Exception {
        Client client = commander();
        client.send(codec.encode(1, new UploadWaypoints("u", "l", NEW)));
        client.await(Ack.class);
        client.send(codec.encode(9, new StopMotors("x")));
        client.await(Ack.class);
        client.send(codec.encode(2, new StartWaypoints("s", "l", 0)));

        assertThat(client.await(Nack.class).reason()).isEqualTo(NackReason.STALE);
        assertThat(client.await(Telemetry.class).mode()).isEqualTo(BoatMode.STOPPED);
    }

    private static byte[] frame(byte[] body) {
        return ByteBuffer.allocate(5 + body.length)
                .putInt(1 + body.length)
                .put((byte) LinkCodec.VERSION)
                .put(body)
                .array();
    }
}
