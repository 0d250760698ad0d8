package org.sami.boat.server.tcp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sami.boat.link.Ack;
import org.sami.boat.link.AskForCommand;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandAsked;
import org.sami.boat.link.GrantCommand;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.Hello;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.FrameBytes;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.tcp.TcpBench.Client;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;

@Timeout(900)
class TcpBoatServerTest {
    private static final List<Waypoint> PATH = List.of(new Waypoint(45.1, 10, 1.5), new Waypoint(45.2, 10, 1.6));
    private static final UnaryOperator<TcpServerConfig> AS_IT_IS = UnaryOperator.identity();

    /** A boat with links of the kind that is tested. */
    TcpBench bench(UnaryOperator<ServerConfig.Builder> boat, UnaryOperator<TcpServerConfig> tcp) throws IOException {
        return new TcpBench(boat, tcp);
    }

    private TcpBench bench() throws IOException {
        return bench(UnaryOperator.identity(), UnaryOperator.identity());
    }

    @Test
    void carriesCommandsAnswersAndTelemetry() throws Exception {
        try (TcpBench bench = bench()) {
            Client client = bench.greet("base", Role.COMMANDER, 10);
            client.say(new UploadWaypoints("u", "l1", PATH));
            assertThat(client.await(Ack.class).commandId()).isEqualTo("u");
            client.say(new ReadBack("r"));
            assertThat(client.await(HeldWaypoints.class).waypoints()).isEqualTo(PATH);
            client.say(new StartWaypoints("s", "l1", 1));
            assertThat(client.await(Ack.class).commandId()).isEqualTo("s");

            assertThat(client.await(Telemetry.class).mode()).isEqualTo(BoatMode.PATH);
            assertThat(bench.executed).containsExactly("u ack", "s ack");
        }
    }

    @Test
    void listensOnLoopbackUnlessToldOtherwise() throws Exception {
        try (TcpBench bench = bench()) {
            assertThat(bench.server.address().getAddress().isLoopbackAddress()).isTrue();
        }
    }

    @Test
    void observersAreRefusedUntilTheCommandIsHandedOver() throws Exception {
        try (TcpBench bench = bench()) {
            Client commander = bench.greet("a", Role.COMMANDER, 1);
            Client observer = bench.greet("b", Role.COMMANDER, 1);
            observer.say(new StopMotors("s1"));
            assertThat(observer.await(Nack.class).reason()).isEqualTo(NackReason.NOT_COMMANDER);

            observer.say(new AskForCommand("ask"));
            assertThat(commander.await(CommandAsked.class).clientId()).isEqualTo("b");
            commander.say(new GrantCommand("grant", "b"));
            assertThat(commander.await(Welcome.class).role()).isEqualTo(Role.OBSERVER);
            assertThat(observer.await(Welcome.class).role()).isEqualTo(Role.COMMANDER);
            observer.say(new StopMotors("s2"));
            assertThat(observer.await(Ack.class).commandId()).isEqualTo("s2");
        }
    }

    @Test
    void clientThatDoesNotReadIsDroppedAndKeepsNobodyWaiting() throws Exception {
        try (TcpBench bench = bench(UnaryOperator.identity(), tcp -> tcp.withQueue(16, 1 << 20))) {
            Client other = bench.greet("other", Role.OBSERVER, 50);
            Client slow = bench.greet("slow", Role.COMMANDER, 50);
            slow.say(new UploadWaypoints("u", "l", Collections.nCopies(5000, PATH.get(0))));
            List<Long> answeredMs = new ArrayList<>();
            for (int i = 0; bench.goodbyes.isEmpty() && i < 2000; i++) {
                try {
                    slow.say(new ReadBack("r" + i)); // 100 kB for each of these, never read
                } catch (IOException e) {
                    break; // dropped
                }
                long askedMs = ProcessClock.ms();
                other.say(new Hello("boat1", "other", Role.OBSERVER, 50, ""));
                other.await(Welcome.class);
                answeredMs.add(ProcessClock.ms() - askedMs);
            }
            Await.until("the slow client is dropped", () -> bench.server.clientCount() == 1);

            assertThat(bench.goodbyes).first().asString().contains("does not take");
            Collections.sort(answeredMs);
            assertThat(answeredMs.get(answeredMs.size() / 2))
                    .as("usual time of an answer to the other, ms")
                    .isLessThan(1000L);
            other.say(new Hello("boat1", "other", Role.COMMANDER, 1, ""));
            assertThat(other.await(Welcome.class).role()).isEqualTo(Role.COMMANDER);
            assertThat(bench.failures).isEmpty();
        }
    }

    /** What else may speak to a boat while its commander is silent. */
    enum Stranger {
        OBSERVER,
        NAMESAKE,
        WITHOUT_HELLO,
        WITH_A_HELLO_FOR_ANOTHER_BOAT,
        PORT_SCAN
    }

    private static void speak(TcpBench bench, Client client, Stranger stranger, int turn) throws Exception {
        switch (stranger) {
            case OBSERVER, WITHOUT_HELLO -> client.say(new Heartbeat(turn));
            case NAMESAKE -> {
                client.say(new Heartbeat(turn));
                client.say(new StopMotors("not-mine" + turn));
            }
            case WITH_A_HELLO_FOR_ANOTHER_BOAT -> {
                client.say(new Hello("boat2", "base", Role.COMMANDER, 10, ""));
                client.say(new Heartbeat(turn));
            }
            case PORT_SCAN -> {
                try (Client scan = bench.connect()) {
                    scan.send("GET / HTTP/1.1\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
                }
            }
        }
    }

    private static Client arrive(TcpBench bench, Stranger stranger) throws Exception {
        return switch (stranger) {
            case OBSERVER -> bench.greet("other", Role.OBSERVER, 20);
            case NAMESAKE -> bench.greet("base", Role.COMMANDER, 20); // an observer: the command is not free
            default -> bench.connect();
        };
    }

    @ParameterizedTest
    @EnumSource(Stranger.class)
    void whateverOthersSayDoesNotMaskALostCommander(Stranger stranger) throws Exception {
        try (TcpBench bench = bench(boat -> boat.lostLinkAfterMs(700), AS_IT_IS).stopTime()) {
            Client watching = bench.greet("watching", Role.OBSERVER, 20);
            Client commander = bench.greet("base", Role.COMMANDER, 1);
            Client other = arrive(bench, stranger);
            startPath(commander);
            long silentSinceMs = bench.timeMs();
            while (bench.nextOf(watching).mode() != BoatMode.PATH) {}

            int turns = 0;
            Telemetry last = bench.nextOf(watching);
            while (last.mode() == BoatMode.PATH) {
                speak(bench, other, stranger, turns++);
                last = bench.nextOf(watching);
            }
            assertThat(last.boatTimeMs() - silentSinceMs).as("ms").isBetween(700L, 900L);
            assertThat(turns).as("times that the other spoke").isGreaterThan(3);
            assertThat(bench.executed).containsExactly("u ack", "s ack");
        }
    }

    private static void startPath(Client commander) throws Exception {
        commander.say(new UploadWaypoints("u", "l", PATH));
        commander.await(Ack.class);
        commander.say(new StartWaypoints("s", "l", 0));
        commander.await(Ack.class);
    }

    @Test
    void silentCommanderIsLostAfterThreeAndAHalfSecondsAndThatIsSeenHalfASecondLaterAtMost() throws Exception {
        try (TcpBench bench = bench().stopTime()) {
            Client watching = bench.greet("watching", Role.OBSERVER, 20);
            Client commander = bench.greet("base", Role.COMMANDER, 1);
            startPath(commander);
            long silentSinceMs = bench.timeMs();
            while (bench.nextOf(watching).mode() != BoatMode.PATH) {}

            Telemetry last = bench.nextOf(watching);
            while (last.mode() == BoatMode.PATH) {
                last = bench.nextOf(watching);
            }
            assertThat(last.boatTimeMs() - silentSinceMs).as("ms").isBetween(3500L, 4000L);
        }
    }

    @Test
    void authIsReservedItIsReadAndNotLookedAt() throws Exception {
        try (TcpBench bench = bench()) {
            Client client = bench.connect();
            client.say(new Hello("boat1", "base", Role.COMMANDER, 1, "anything"));
            Welcome welcome = client.await(Welcome.class);
            assertThat(welcome.role()).isEqualTo(Role.COMMANDER);
            assertThat(welcome.auth()).isEmpty();

            client.say(new Hello("boat1", "base", Role.COMMANDER, 1, "x".repeat(1000)));
            client.await(Welcome.class);
            String number =
                    "{\"type\":\"hello\",\"seq\":9,\"boat\":\"boat1\",\"client\":\"base\",\"role\":\"COMMANDER\","
                            + "\"telemetryHz\":1,\"auth\":7}";
            client.send(FrameBytes.of(number));
            assertThat(client.await(Nack.class).detail()).contains("/auth");
        }
    }

    @Test
    void closedSocketOfTheCommanderIsALostLinkAtOnce() throws Exception {
        try (TcpBench bench = bench().stopTime()) {
            Client observer = bench.greet("observer", Role.OBSERVER, 50);
            Client commander = bench.greet("base", Role.COMMANDER, 1);
            startPath(commander);
            while (bench.nextOf(observer).mode() != BoatMode.PATH) {}
            commander.close();
            Await.until("the boat sees it", bench::hasSeenOneGo);
            long closedMs = bench.timeMs();

            Telemetry last = bench.nextOf(observer);
            while (last.mode() != BoatMode.HOLD) {
                last = bench.nextOf(observer);
            }
            assertThat(last.boatTimeMs() - closedMs)
                    .as("ms; a silent one is lost after 3500")
                    .isLessThan(500);
        }
    }

    @Test
    void clockSetBackAnHourFiresNothingEarlyOrLate() throws Exception {
        try (TcpBench bench = bench(boat -> boat.deadmanMs(1000), AS_IT_IS)) {
            Client client = bench.greet("base", Role.COMMANDER, 50);
            client.say(new Teleoperate(0.5, 0));
            Telemetry last = client.await(Telemetry.class);
            while (last.mode() != BoatMode.TELEOPERATION) {
                last = client.await(Telemetry.class);
            }
            long setMs = last.boatTimeMs();
            bench.passMs(-3_600_000);

            while (last.mode() == BoatMode.TELEOPERATION) {
                client.say(new Heartbeat(1));
                last = client.await(Telemetry.class);
            }
            assertThat(last.boatTimeMs() - setMs).as("ms").isBetween(800L, 1200L);
        }
    }

    @Test
    void hundredClientsComeAndGoAndLeaveNoThread() throws Exception {
        try (TcpBench bench = bench()) {
            Client watching = bench.greet("watching", Role.OBSERVER, 10);
            long before = Await.threads(bench.name);
            for (int i = 0; i < 100; i++) {
                bench.greet("client" + i, i % 2 == 0 ? Role.COMMANDER : Role.OBSERVER, 50)
                        .close();
            }

            Await.until("their threads end", () -> Await.threads(bench.name) == before);
            assertThat(bench.server.clientCount()).isEqualTo(1);
            watching.await(Telemetry.class);
            assertThat(bench.failures).isEmpty();
        }
    }

    @Test
    void stoppingEndsAllThreadsAndFreesThePort() throws Exception {
        TcpBench bench = bench();
        Client client = bench.greet("base", Role.COMMANDER, 50);
        int port = bench.server.address().getPort();
        bench.server.close();

        assertThat(client.isClosedByTheBoat()).isTrue();
        Await.until("all threads end", () -> Await.threads(bench.name) == 0);
        try (ServerSocket again = new ServerSocket()) {
            again.setReuseAddress(true);
            again.bind(new java.net.InetSocketAddress(java.net.InetAddress.getLoopbackAddress(), port));
        }
        bench.close();
    }

    @Test
    void portThatIsTakenIsSaidAndLeavesNoThread() throws Exception {
        try (TcpBench bench = bench()) {
            int taken = bench.server.address().getPort();

            String second = bench.name + "-second"; // the same test runs with TLS meanwhile

            assertThatThrownBy(() ->
                            new TcpBench(second, UnaryOperator.identity(), tcp -> TcpServerConfig.onLoopback(taken)))
                    .isInstanceOf(IOException.class);
            Await.until("all threads end", () -> Await.threads(second) == 0);
        }
    }
}
