package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandAsked;
import org.sami.boat.link.Gains;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Progress;
import org.sami.boat.link.Role;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.crw.sim.boat.TcpTestFleet.Base;

/** A base one of whose addresses talks rubbish: it survives, says what it hears, and its other boat drives on. */
@Execution(ExecutionMode.CONCURRENT)
@Timeout(900)
class MalformedPeerTest {
    @TempDir
    private Path logs;

    /** How boats and bases are linked. */
    TestLinks links() {
        return TestLinks.plain();
    }

    private final LinkCodec codec = new LinkCodec();
    private TcpTestFleet fleet;
    private Base base;

    @BeforeEach
    void sendAGoodBoatOnItsWay() throws IOException {
        fleet = new TcpTestFleet(logs, links());
        base = fleet.base("base");
        base.connect(fleet.boat("anna").address(), "anna");
        base.submit("anna", TcpTestFleet.path("p", 1));
        base.awaitMode("anna", BoatMode.PATH);
    }

    @AfterEach
    void close() throws Exception {
        fleet.close();
    }

    private static List<LinkMessage> everythingThatBoatsSay() {
        List<Waypoint> path = List.of(new Waypoint(45.5, 10.9, 1.5));
        return List.of(
                new Welcome("berta", "boot1", Role.COMMANDER, ""),
                new Welcome("anna", "boot2", Role.COMMANDER, ""),
                new Welcome("berta", "boot2", Role.OBSERVER, "?"),
                new Goodbye("berta", "no"),
                new Heartbeat(Long.MAX_VALUE),
                new Ack("nobody-asked"),
                new Nack("", NackReason.MALFORMED, "what?"),
                new Nack("p#base.0.1", NackReason.NOT_GREETED, ""),
                new HeldWaypoints("r", "l", path),
                new CommandAsked("other"),
                new Telemetry(90, -180, 7, -50, 0, BoatMode.FLEET_STOP, 0),
                new BatteryReport(0, BatteryLevel.CRITICAL),
                new Progress("p#base.0.1", Integer.MAX_VALUE, true),
                new Progress("", 5, false),
                new SettingsReport(new Gains(0, 0, 0), new Gains(1000, 0, 0), 0, LostLinkAction.DRIFT),
                new SensorReport("s", "c", Collections.nCopies(64, 1e300), "", 0, 0, 0),
                new Hello("", "berta", Role.COMMANDER, 1, ""), // what only bases say
                new UploadWaypoints("u", "l", path),
                new StopMotors("s"));
    }

    private void assertTheBaseIsWell(MalformedPeer raving) {
        assertThat(base.failures).isEmpty();
        assertThat(base.mode("anna")).contains(BoatMode.PATH);
        assertThat(base.count("anna LOST")).isZero();
        assertThat(base.links()).hasSize(2).anySatisfy(link -> {
            assertThat(link.address()).isEqualTo(raving.address());
            assertThat(link.lastEvent()).isNotEmpty();
        });
    }

    private void hear(int connections, MalformedPeer.Speech speech) throws Exception {
        try (MalformedPeer raving = new MalformedPeer(fleet.kindOfLinks().ofPeer("berta"), speech)) {
            base.tcp.connect(raving.address());
            Await.until("it has been heard", () -> raving.spoken() >= connections);
            assertTheBaseIsWell(raving);
        }
    }

    @Test
    void noise() throws Exception {
        SplittableRandom random = new SplittableRandom(71);
        hear(6, (connection, to) -> {
            byte[] noise = new byte[2 << 20];
            for (int i = 0; i < noise.length; i++) {
                noise[i] = (byte) random.nextInt();
            }
            if (connection % 2 == 1) { // as one well-framed message
                to.write(ByteBuffer.allocate(LinkCodec.HEADER_BYTES)
                        .putInt(noise.length + 5)
                        .put((byte) LinkCodec.VERSION)
                        .array());
            }
            to.write(noise);
        });
    }

    @Test
    void lengthsOfTwoGigabytesAndFramesThatEndInTheMiddle() throws Exception {
        List<LinkMessage> messages = everythingThatBoatsSay();
        SplittableRandom random = new SplittableRandom(72);
        hear(30, (connection, to) -> {
            if (connection % 3 == 0) {
                to.write(ByteBuffer.allocate(4)
                        .putInt(connection == 0 ? Integer.MAX_VALUE : Integer.MIN_VALUE)
                        .array());
            } else {
                byte[] frame = codec.encode(0, messages.get(connection % messages.size()));
                to.write(Arrays.copyOf(frame, random.nextInt(frame.length)));
            }
        });
    }

    @Test
    void everyMessageInAnyOrderWholeBentAndAgain() throws Exception {
        SplittableRandom random = new SplittableRandom(73);
        hear(20, (connection, to) -> {
            welcome(to, connection);
            List<LinkMessage> messages = everythingThatBoatsSay();
            for (int i = 0; i < 500; i++) {
                byte[] frame = codec.encode(random.nextInt(1000), messages.get(random.nextInt(messages.size())));
                if (random.nextInt(3) == 0) { // the length stays: the stream goes on
                    frame[4 + random.nextInt(frame.length - 4)] ^= (byte) (1 << random.nextInt(8));
                }
                to.write(frame);
            }
        });
    }

    @Test
    void boatOfAnEarlierVersionIsAlarmedOnceAndNamedAsSuch() throws Exception {
        try (MalformedPeer yesterday = new MalformedPeer(fleet.kindOfLinks().ofPeer("berta"), (connection, to) -> {
            byte[] refusal = LinkCodec.body(
                    new Nack("", NackReason.MALFORMED, "VERSION at the frame: version 2 is not read here"));
            to.write(ByteBuffer.allocate(5 + refusal.length)
                    .putInt(1 + refusal.length)
                    .put((byte) 1)
                    .put(refusal)
                    .array());
        })) {
            base.tcp.connect(yesterday.address());
            Await.until("it is tried again", () -> yesterday.spoken() >= 3);

            assertThat(base.alarms).singleElement().satisfies(alarm -> {
                assertThat(alarm.kind()).isEqualTo(LinkAlarm.Kind.OTHER_VERSION);
                assertThat(alarm.text())
                        .contains(":" + yesterday.address().getPort())
                        .contains("speaks link version 1, this base version 2");
            });
            Await.until(
                    "the link says so", () -> base.links().get(1).lastEvent().contains("speaks link version 1"));
            assertThat(base.mode("anna")).contains(BoatMode.PATH);
        }
    }

    private void welcome(OutputStream to, int connection) throws IOException {
        to.write(codec.encode(0, new Welcome("berta", "boot" + connection % 2, Role.COMMANDER, "")));
    }
}
