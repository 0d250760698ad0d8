package org.sami.boat.server.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.link.Ack;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.Role;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.tcp.TcpBench.Client;
import org.sami.boat.server.testing.Await;

/** Who is let in, and who is turned away for whom. */
@Timeout(900)
class TcpAdmissionTest {
    private static final String SILENT = "it has been silent for too long";
    private static final UnaryOperator<ServerConfig.Builder> AS_IS = UnaryOperator.identity();

    /** A boat with links of the kind that is tested. */
    TcpBench bench(UnaryOperator<ServerConfig.Builder> boat, UnaryOperator<TcpServerConfig> tcp) throws IOException {
        return new TcpBench(boat, tcp);
    }

    private TcpBench bench() throws IOException {
        return bench(AS_IS, UnaryOperator.identity());
    }

    @Test
    void clientThatDoesNotSayWhoItIsIsDropped() throws Exception {
        try (TcpBench bench = bench(UnaryOperator.identity(), tcp -> tcp.withPatience(200, 600_000))) {
            Client silent = bench.connect();

            assertThat(silent.isClosedByTheBoat()).isTrue();
            Await.until("it is said why", () -> bench.goodbyes.contains("it does not say who it is"));
        }
    }

    @Test
    void clientOfWhichNothingMoreComesIsDropped() throws Exception {
        CountDownLatch goOn = new CountDownLatch(1);
        try (TcpBench bench = bench(AS_IS, tcp -> tcp.withPatience(600_000, 1000))) {
            Client halfOpen = bench.greet("base", Role.OBSERVER, 10);
            bench.duringTick = () -> Await.latch(goOn); // or the boat may say first that it reads nothing

            assertThat(halfOpen.isClosedByTheBoat()).isTrue();
            Await.until("it is said why", () -> bench.goodbyes.contains(SILENT));
            goOn.countDown();
        }
    }

    @Test
    void clientWhoseFrameNeverEndsIsDropped() throws Exception {
        try (TcpBench bench = bench(AS_IS, tcp -> tcp.withPatience(600_000, 3000))) {
            do {
                bench.goodbyes.clear();
                mumble(bench);
            } while (bench.goodbyes.contains(SILENT)); // on a machine that stood still meanwhile

            assertThat(bench.goodbyes).containsExactly("it says nothing that can be read");
        }
    }

    /** Says a byte of a long frame now and then until it is dropped. */
    private static void mumble(TcpBench bench) throws Exception {
        Client mumbling = bench.greet("base", Role.COMMANDER, 10);
        mumbling.send(ByteBuffer.allocate(4).putInt(LinkCodec.DEFAULT_MAX_BYTES).array()); // a flipped bit in a length
        Await.until("it is dropped", () -> {
            try {
                mumbling.send(new byte[] {2});
            } catch (IOException dropped) {
                // and it is said why
            }
            return !bench.goodbyes.isEmpty();
        });
    }

    @Test
    void oneObserverTooManyIsToldSoAndTurnedAway() throws Exception {
        try (TcpBench bench = bench(UnaryOperator.identity(), tcp -> tcp.withMaxClients(2))) {
            Client first = bench.greet("a", Role.COMMANDER, 10);
            bench.greet("b", Role.OBSERVER, 10);

            Client third = bench.greet("c", Role.OBSERVER, 10);
            assertThat(third.await(Goodbye.class).reason()).contains("serves 2 clients");
            assertThat(third.isClosedByTheBoat()).isTrue();
            first.await(Telemetry.class);
            first.close();
            Await.until("there is room", () -> bench.server.clientCount() == 1);
            bench.greet("d", Role.OBSERVER, 10);
        }
    }

    @Test
    void commanderFindsAPlaceBesideSixteenObserversThatAllSpeak() throws Exception {
        try (TcpBench bench = bench()) {
            List<Client> observers = new ArrayList<>();
            for (int i = 0; i < 16; i++) {
                observers.add(bench.greet("observer" + i, Role.OBSERVER, 1));
            }
            for (int i = 1; i <= 3; i++) {
                Client base = bench.greet("base" + i, Role.OBSERVER, 0); // as a base finds out who answers
                for (Client observer : observers.subList(0, 12)) {
                    observer.say(new Heartbeat(1));
                }
                base.say(new Hello("boat1", "base" + i, Role.COMMANDER, 10, ""));
                assertThat(base.await(Welcome.class).role()).isEqualTo(Role.COMMANDER);
                base.say(new StopMotors("s" + i));
                assertThat(base.await(Ack.class).commandId()).isEqualTo("s" + i);
                base.close();
                Await.until("nobody commands", bench::hasSeenOneGo);
                bench.goodbyes.clear();
            }
            Client base = bench.greet("base", Role.COMMANDER, 10);
            assertThat(observers.get(15).isClosedByTheBoat())
                    .as("who came last")
                    .isTrue();
            observers.get(0).await(Telemetry.class);
            base.await(Telemetry.class);
            assertThat(bench.failures).isEmpty();
        }
    }

    @Test
    void baseThatComesBackOverAndOverWithoutClosingItsSocketsIsAlwaysLetIn() throws Exception {
        try (TcpBench bench = bench().stopTime()) {
            Client observer = bench.greet("observer", Role.OBSERVER, 10);
            Client last = observer;
            for (int i = 0; i < 40; i++) {
                bench.passMs(300);
                observer.say(new Heartbeat(i));
                last = bench.greet("base", Role.COMMANDER, 10);
            }
            bench.nextOf(last);
            bench.nextOf(observer);
            for (int i = 0; i < 40; i++) { // and faster than sockets can be known to be dead
                last = bench.greet("base", Role.COMMANDER, 10);
            }

            bench.nextOf(last);
            bench.passMs(4000); // the first of its sockets counts as lost
            last.say(new Hello("boat1", "base", Role.COMMANDER, 10, ""));
            assertThat(last.await(Welcome.class).role()).isEqualTo(Role.COMMANDER);
            last.say(new StopMotors("s"));
            assertThat(last.await(Ack.class).commandId()).isEqualTo("s");
            assertThat(bench.server.clientCount()).isLessThanOrEqualTo(24);
            assertThat(bench.failures).isEmpty();
        }
    }

    @Test
    void silentSocketMakesRoomBeforeAClientThatSpeaks() throws Exception {
        try (TcpBench bench = bench(AS_IS, tcp -> tcp.withMaxClients(3)).stopTime()) {
            Client commander = bench.greet("base", Role.COMMANDER, 10);
            Client silent = bench.greet("half-open", Role.OBSERVER, 1);
            Client speaks = bench.greet("speaks", Role.OBSERVER, 10);
            bench.passMs(3000);
            commander.say(new Hello("boat1", "base", Role.COMMANDER, 10, ""));
            commander.await(Welcome.class); // the boat has heard it
            speaks.say(new Hello("boat1", "speaks", Role.OBSERVER, 10, ""));
            speaks.await(Welcome.class);
            bench.passMs(1000);
            Client next = bench.greet("next", Role.COMMANDER, 10);

            assertThat(silent.isClosedByTheBoat()).isTrue();
            bench.nextOf(next);
            bench.nextOf(speaks);
            bench.nextOf(commander);
        }
    }

    @Test
    void baseOfAnEarlierVersionIsToldWhichVersionsMeet() throws Exception {
        try (TcpBench bench = bench()) {
            Client yesterday = bench.connect();
            byte[] hello = LinkCodec.body(new Hello("boat1", "base", Role.COMMANDER, 1, ""));
            yesterday.send(ByteBuffer.allocate(5 + hello.length)
                    .putInt(1 + hello.length)
                    .put((byte) 1)
                    .put(hello)
                    .array());

            byte[] itsOwn = yesterday.nextFrame();
            assertThat(itsOwn[4]).isEqualTo((byte) 1);
            assertThat(new String(itsOwn, 5, itsOwn.length - 5, StandardCharsets.UTF_8))
                    .contains("\"type\":\"goodbye\"")
                    .contains("the base speaks link version 1, this boat version 2");
            assertThat(yesterday.await(Goodbye.class).reason()).contains("bring both to the same version");
            assertThat(yesterday.isClosedByTheBoat()).isTrue();
            Await.until(
                    "it is said why", () -> bench.goodbyes.contains("it speaks link version 1, this boat version 2"));
            assertThat(bench.executed).isEmpty();
        }
    }

    @Test
    void strangersWhoSayNothingKeepNobodyOut() throws Exception {
        try (TcpBench bench = bench(UnaryOperator.identity(), tcp -> tcp.withMaxClients(4))) {
            Client commander = bench.greet("base", Role.COMMANDER, 10);
            List<Client> scan = new ArrayList<>();
            for (int i = 0; i < 20; i++) {
                scan.add(bench.connect());
                scan.get(i).send("GET / HTTP/1.0\r\n".substring(0, i % 4).getBytes(StandardCharsets.US_ASCII));
            }
            bench.greet("watch", Role.OBSERVER, 10).await(Telemetry.class);

            assertThat(scan.get(0).isClosedByTheBoat()).isTrue();
            commander.await(Telemetry.class);
            assertThat(bench.goodbyes).contains("it has not said who it is, and another one comes");
        }
    }
}
