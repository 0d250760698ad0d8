package org.sami.boat.server.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.link.Ack;
import org.sami.boat.link.AskForCommand;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandAsked;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.GrantCommand;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.Hello;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.Role;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.SetGains;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SetVelocityMultiplier;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.FrameBytes;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.tcp.TcpBench.Client;
import org.sami.boat.server.testing.Await;

/** Streams that are cut, bent, doubled or never were frames: the boat stays whole, and serves the next client. */
@Timeout(900)
class HostileTcpClientTest {
    private static final int MANY = 60; // frames of a third of a megabyte: more than sockets hold

    private static final List<Waypoint> OLD = List.of(new Waypoint(45.1, 10, 1));
    private static final List<Waypoint> NEW = List.of(new Waypoint(45.2, 10, 1), new Waypoint(45.3, 10, 1));

    private final LinkCodec codec = new LinkCodec();
    private TcpBench bench;

    /** A boat with links of the kind that is tested. */
    TcpBench bench(UnaryOperator<ServerConfig.Builder> boat, UnaryOperator<TcpServerConfig> tcp) throws IOException {
        return new TcpBench(boat, tcp);
    }

    /** By how many bytes cuts of a message are apart. */
    int bytesBetweenCuts() {
        return 1;
    }

    private TcpBench bench() throws IOException {
        return bench(UnaryOperator.identity(), UnaryOperator.identity());
    }

    @BeforeEach
    void open() throws IOException {
        bench = bench();
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

    /** One of each message that a client can send, and of those that only boats have reason to. */
    private static List<LinkMessage> everyMessage() {
        List<LinkMessage> all = new ArrayList<>(commands());
        all.addAll(List.of(
                new Hello("boat1", "other", Role.COMMANDER, 10, "secret"),
                new Heartbeat(1),
                new FleetRelease("fr"),
                new AskForCommand("ask"),
                new GrantCommand("grant", "other"),
                new TakeCommand("take"),
                new Teleoperate(1, 1),
                new SetGains("g", GainAxis.HEADING, 9, 9, 9),
                new SetVelocityMultiplier("v", 9),
                new SetLostLinkAction("ll", LostLinkAction.DRIFT),
                new Welcome("boat1", "boot", Role.COMMANDER, ""),
                new Goodbye("boat1", "why"),
                new Ack("a"),
                new Nack("n", NackReason.STALE, "late"),
                new HeldWaypoints("hw", "l", NEW),
                new CommandAsked("other"),
                new Telemetry(45, 10, 0, 0, 50, BoatMode.PATH, 1),
                new BatteryReport(50, BatteryLevel.NOMINAL),
                new Progress("l", 1, false),
                new SettingsReport(new Gains(1, 0, 0), new Gains(1, 0, 0), 1, LostLinkAction.HOLD),
                new SensorReport("water", "temperature", List.of(17.5), "°C", 45, 10, 1)));
        return all;
    }

    /** The boat still does what a good client asks for. */
    private void assertServes() throws Exception {
        try (Client good = commander()) {
            good.say(new UploadWaypoints("good-u", "good", OLD));
            assertThat(good.await(Ack.class).commandId()).isEqualTo("good-u");
            good.say(new ReadBack("good-r"));
            assertThat(good.await(HeldWaypoints.class).waypoints()).isEqualTo(OLD);
            assertThat(good.await(Telemetry.class).latDeg()).isEqualTo(45);
        }
    }

    /** A commander in a boat that may still have to learn that its last one has gone. */
    private Client commander() throws Exception {
        Await.until("the last client is gone", () -> bench.server.clientCount() == 0);
        return bench.greet("base", Role.COMMANDER, 10);
    }

    @Test
    void noPrefixOfAnyMessageIsExecuted() throws Exception {
        List<LinkMessage> messages = everyMessage();
        assertThat(messages.stream().map(LinkMessage::type))
                .doesNotHaveDuplicates()
                .hasSize(27);
        int cuts = 0;
        for (LinkMessage message : messages) {
            byte[] frame = codec.encode(7, message);
            for (int length = 0; length < frame.length; length += bytesBetweenCuts()) {
                try (Client client = commander()) {
                    client.send(Arrays.copyOf(frame, length));
                }
                cuts++;
            }
        }

        assertThat(cuts).isGreaterThan(1900 / bytesBetweenCuts());
        assertThat(bench.executed).isEmpty();
        assertThat(commander().await(Telemetry.class).mode())
                .as("no command has moved it")
                .isEqualTo(BoatMode.STOPPED);
        bench.closeClients();
        assertServes();
    }

    @Test
    void cutUploadLeavesTheWholeOldListAndAWholeOneTheNew() throws Exception {
        try (Client client = commander()) {
            client.say(new UploadWaypoints("u0", "old", OLD));
            client.await(Ack.class);
        }
        boolean whole = false;
        for (int length = 1; !whole; length++) {
            try (Client client = commander()) {
                byte[] frame = client.frame(7, new UploadWaypoints("u1", "new", NEW));
                whole = length == frame.length;
                client.send(Arrays.copyOf(frame, length));
                client.socket.shutdownOutput();
                client.isClosedByTheBoat();
            }
            try (Client client = commander()) {
                client.say(new ReadBack("r" + length));
                HeldWaypoints held = client.await(HeldWaypoints.class);
                assertThat(held.listId()).isEqualTo(whole ? "new" : "old");
                assertThat(held.waypoints()).isEqualTo(whole ? NEW : OLD);
            }
        }
    }

    @Test
    void flippedBitsAreRefusedOrDropTheClient() throws Exception {
        SplittableRandom random = new SplittableRandom(61);
        List<LinkMessage> messages = new ArrayList<>(everyMessage());
        messages.removeIf(message -> message instanceof FleetStop); // it would stay latched
        for (int round = 0; round < 500; round++) {
            try (Client client = commander()) {
                byte[] frame = client.frame(7, messages.get(round % messages.size()));
                frame[random.nextInt(frame.length)] ^= (byte) (1 << random.nextInt(8));
                frame[random.nextInt(frame.length)] ^= (byte) (0x11 << random.nextInt(4));
                client.send(frame);
                client.socket.shutdownOutput();
                assertThat(client.isClosedByTheBoat()).isTrue();
            }
        }

        assertThat(bench.executed).isEmpty();
        assertServes();
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
        client.send(FrameBytes.of(nan));
        assertThat(client.await(Nack.class).reason()).isEqualTo(NackReason.MALFORMED);
        client.send(FrameBytes.of(far));
        assertThat(client.await(Nack.class).commandId()).isEqualTo("c2");
        client.send(FrameBytes.of(new byte[] {'{', '"', (byte) 0xc3, '(', '"', '}'}));
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
            frames.add(client.frame(i + 1, commands.get(i)));
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
    void framesInAnyOrderAndTenTimesOverAreExecutedOnceAtMost() throws Exception {
        SplittableRandom random = new SplittableRandom(63);
        for (int round = 0; round < 20; round++) {
            bench.executed.clear();
            List<byte[]> frames = new ArrayList<>();
            List<LinkMessage> commands = List.of(
                    new UploadWaypoints("u" + round, "l", NEW),
                    new StartWaypoints("s" + round, "l", 0),
                    new HoldPosition("h" + round),
                    new StopMotors("x" + round));
            try (Client client = commander()) {
                for (int copy = 0; copy < 10; copy++) {
                    for (int i = 0; i < commands.size(); i++) {
                        frames.add(client.frame(i + 1, commands.get(i)));
                    }
                }
                for (int i = frames.size() - 1; i > 0; i--) {
                    Collections.swap(frames, i, random.nextInt(i + 1));
                }
                for (byte[] frame : frames) {
                    client.send(frame);
                }
                client.socket.shutdownOutput();
                assertThat(client.isClosedByTheBoat()).isTrue();
            }
            commander().close(); // who is welcome once the boat has done with the one before

            assertThat(bench.executed.stream().map(line -> line.split(" ")[0]))
                    .doesNotHaveDuplicates()
                    .contains("x" + round);
        }
        assertServes();
    }

    @Test
    void motionThatComesThirtySecondsLateIsRefusedAndAStopIsNot() throws Exception {
        try (TcpBench late = bench().stopTime()) {
            Client client = late.greet("base", Role.COMMANDER, 20);
            client.say(new UploadWaypoints("u", "l", NEW));
            client.await(Ack.class);
            late.passMs(30_000);

            client.say(new StartWaypoints("s", "l", 0));
            assertThat(client.await(Nack.class).reason()).isEqualTo(NackReason.NOT_GREETED);
            client.say(new Teleoperate(1, 0));
            while (late.nextOf(client).boatTimeMs() < 30_000) {}
            assertThat(late.nextOf(client).mode()).isEqualTo(BoatMode.STOPPED);
            client.say(new StopMotors("x"));
            assertThat(client.await(Ack.class).commandId()).isEqualTo("x");
            client.say(new Hello("boat1", "base", Role.COMMANDER, 20, ""));
            client.await(Welcome.class);
            client.say(new StartWaypoints("s2", "l", 0));
            assertThat(client.await(Ack.class).commandId()).isEqualTo("s2");
            assertThat(late.executed).containsExactly("u ack", "x ack", "s2 ack");
        }
    }

    @Test
    void lengthsThatAreDeclaredAndNotSentTakeNoMemory() throws Exception {
        byte[] declared = ByteBuffer.allocate(4 + 10)
                .putInt(LinkCodec.DEFAULT_MAX_BYTES)
                .put((byte) LinkCodec.VERSION)
                .array();
        Client watching = bench.greet("watching", Role.OBSERVER, 20);
        List<Client> clients = new ArrayList<>();
        for (int i = 0; i < 10; i++) {
            clients.add(bench.connect());
        }
        Await.until("all are connected", () -> bench.server.clientCount() == 11);
        long connected = bench.bytesAllocatedByReaders();
        for (Client client : clients) {
            client.send(declared);
        }
        for (int i = 0; i < 10; i++) {
            watching.await(Telemetry.class); // the bytes are there by now
        }

        assertThat(bench.bytesAllocatedByReaders() - connected).isLessThan(10 * 200_000L);
        assertThat(bench.executed).isEmpty();
    }

    @Test
    void clientThatSendsFasterThanTheBoatWorksHasToWait() throws Exception {
        CountDownLatch goOn = new CountDownLatch(1);
        try (TcpBench busy = bench()) {
            Client client = busy.greet("base", Role.COMMANDER, 1);
            CountDownLatch stands = new CountDownLatch(1);
            busy.duringTick = () -> {
                stands.countDown();
                Await.latch(goOn);
            };
            Await.latch(stands); // the boat works on nothing from now on
            byte[] frame = client.frame(7, new UploadWaypoints("u", "l", Collections.nCopies(20_000, OLD.get(0))));
            AtomicInteger sent = new AtomicInteger();
            Thread sender = new Thread(() -> sendMany(client, frame, MANY, sent), busy.name + "-sender");
            sender.start();
            Await.untilStill("it has to wait", 0.5, sent::get);

            assertThat(sent.get() * (long) frame.length)
                    .as("bytes in two frames, and in the sockets")
                    .isLessThan(32 << 20)
                    .isLessThan((long) MANY * frame.length);
            goOn.countDown();
            Await.until("all are sent", 240, () -> sent.get() == MANY); // a megabyte each, which the boat reads
            client.say(new StopMotors("x"));
            while (!client.await(Ack.class).commandId().equals("x")) {}
            assertThat(busy.executed).containsExactly("u ack", "x ack");
        }
    }

    private static void sendMany(Client client, byte[] frame, int times, AtomicInteger sent) {
        try {
            for (int i = 0; i < times; i++) {
                client.send(frame);
                sent.incrementAndGet();
            }
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    @Test
    void motionThatComesAfterALaterCommandIsRefused() throws Exception {
        Client client = commander();
        client.send(client.frame(1, new UploadWaypoints("u", "l", NEW)));
        client.await(Ack.class);
        client.send(client.frame(9, new StopMotors("x")));
        client.await(Ack.class);
        client.send(client.frame(2, new StartWaypoints("s", "l", 0)));

        assertThat(client.await(Nack.class).reason()).isEqualTo(NackReason.STALE);
        assertThat(client.await(Telemetry.class).mode()).isEqualTo(BoatMode.STOPPED);
    }
}
