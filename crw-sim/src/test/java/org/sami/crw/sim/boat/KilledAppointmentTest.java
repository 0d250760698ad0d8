package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Role;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.BoatServerDefaults;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.ServerLog;
import org.sami.boat.server.log.CommandLogFile;
import org.sami.boat.server.log.LogPlace;
import org.sami.boat.server.tcp.LogFaultReports;
import org.sami.boat.server.tcp.TcpBoatServer;
import org.sami.boat.server.tcp.TcpServerConfig;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.TcpBase;
import org.sami.crw.proxy.tcp.TcpBaseConfig;
import org.sami.crw.sim.boat.TcpTestFleet.Base;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.crw.sim.hull.SimulatedHull;
import org.sami.spn.testing.JavaProcess;

/** Processes that are killed as by {@code kill -9} in the middle of an appointment: its number counts from the moment in which the boat acts on it. */
@Tag("process")
@Timeout(900)
class KilledAppointmentTest {
    @TempDir
    private Path logs;

    private TcpTestFleet fleet;
    private Process process;

    @BeforeEach
    void open() {
        fleet = new TcpTestFleet(logs);
    }

    @AfterEach
    void close() throws Exception {
        if (process != null) {
            process.destroyForcibly().waitFor();
        }
        fleet.close();
    }

    private BufferedReader start(Class<?> main, String argument) throws IOException {
        process = JavaProcess.builder(logs, main, argument)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        return new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    }

    private static void say(Socket socket, LinkMessage message) throws IOException {
        socket.getOutputStream().write(new LinkCodec().encode(new Frame(0, "", message)));
    }

    private static <M extends LinkMessage> M hear(FrameReader frames, Class<M> kind) throws IOException, LinkException {
        while (true) {
            Optional<byte[]> next = frames.next();
            LinkMessage message = new LinkCodec()
                    .decode(next.orElseThrow(() -> new IOException("closed")))
                    .message();
            if (kind.isInstance(message)) {
                return kind.cast(message);
            }
        }
    }

    private static Socket socket(int port) throws IOException {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setSoTimeout(60_000);
        return socket;
    }

    @Test
    void boatThatIsKilledBeforeItAnswersAnAppointmentKeepsItsNumber() throws Exception {
        BufferedReader said = start(BoatThatNeverAnswers.class, logs.toString());
        try (Socket socket = socket(Integer.parseInt(said.readLine()))) {
            say(socket, new Hello("anna", "first", Role.COMMANDER, 1, "", "first.0", 7));
            assertThat(said.readLine()).isEqualTo("appointed 7");
            process.destroyForcibly().waitFor();
            FrameReader frames = new FrameReader(socket.getInputStream(), new LinkCodec());
            assertThatThrownBy(() -> hear(frames, Welcome.class)).isInstanceOf(IOException.class);
        }

        int port = fleet.boat("anna").address().getPort();

        try (Socket replaced = socket(port);
                Socket same = socket(port)) {
            say(replaced, new Hello("anna", "second", Role.COMMANDER, 1, "", "second.0", 6));
            FrameReader frames = new FrameReader(replaced.getInputStream(), new LinkCodec());
            assertThat(hear(frames, Welcome.class).role()).isEqualTo(Role.OBSERVER);
            Nack refused = hear(frames, Nack.class);
            assertThat(refused.reason()).isEqualTo(NackReason.SUPERSEDED);
            assertThat(refused.detail()).contains("first has the command, number 7");

            say(same, new Hello("anna", "first", Role.COMMANDER, 1, "", "first.0", 7));
            FrameReader own = new FrameReader(same.getInputStream(), new LinkCodec());
            assertThat(hear(own, Welcome.class).role()).isEqualTo(Role.COMMANDER);
        }
    }

    @Test
    void baseThatIsKilledWhileItTakesABoatOverLeavesItToNobodyWhoWasReplaced() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        Base first = fleet.base("first");
        first.connect(boat.address(), "anna");
        Await.until("the first commands", () -> first.ask("anna", BoatProxy::isCommanding));
        Path kept = logs.resolve("anna.log.epoch");
        byte[] before = Files.readAllBytes(kept);

        BufferedReader said = start(BaseThatTakes.class, "" + boat.address().getPort());
        assertThat(said.readLine()).isEqualTo("takes");
        Await.until("the boat keeps the number", () -> !Arrays.equals(before, read(kept)));
        process.destroyForcibly().waitFor();

        Await.until("the first observes", () -> !first.ask("anna", BoatProxy::isCommanding));
        first.ask("anna", proxy -> {
            proxy.handOver().askForCommand();
            return true;
        });
        Await.until(
                "the first is refused",
                () -> first.heard.stream().anyMatch(line -> line.contains("second has the command, number 2")));
        assertThat(first.ask("anna", BoatProxy::isCommanding)).isFalse();
        assertThat(fleet.executed("anna", "start")).isZero();
        first.ask("anna", proxy -> {
            proxy.handOver().takeCommand();
            return true;
        });
        Await.until("its operator has the boat again", () -> first.ask("anna", BoatProxy::isCommanding));
    }

    private static byte[] read(Path file) {
        try {
            return Files.readAllBytes(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A boat that keeps an appointment on its disk, says so to the test, and stands still before it answers. */
    static final class BoatThatNeverAnswers {
        private BoatThatNeverAnswers() {}

        public static void main(String[] args) throws Exception {
            LogPlace place = new LogPlace(Path.of(args[0], "anna.log"), BoatServerDefaults.LOG_BYTES);
            TcpServerListener broken = new TcpServerListener() {
                @Override
                public void failed(String what, Throwable cause) {
                    System.exit(1);
                }
            };
            CommandLogFile file =
                    CommandLogFile.open(place, "boot", entry -> {}, new LogFaultReports(place.file(), broken));
            ServerLog log = new ServerLog() {
                @Override
                public void answered(long nowMs, String clientId, CommandMessage command, LinkMessage answer) {
                    file.answered(nowMs, clientId, command, answer);
                }

                @Override
                public void appointed(CommandEpoch epoch) {
                    file.appointed(epoch);
                    System.out.println("appointed " + epoch.number());
                    Await.latch(new CountDownLatch(1));
                }
            };
            SimulatedHull hull = new SimulatedHull(
                    HullConfig.DEFAULT,
                    new LocalFrame(TcpTestFleet.PIER.latDeg(), TcpTestFleet.PIER.lonDeg()),
                    0,
                    0,
                    1);
            BoatServer boat = new BoatServer(ServerConfig.of("anna", "boot").build(), hull, log);
            TcpBoatServer server = new TcpBoatServer(
                    "anna",
                    boat,
                    TcpServerConfig.onLoopback(0),
                    SteadyClock.ofThisMachine(),
                    nowMs -> {},
                    TcpServerListener.NONE);
            server.start();
            System.out.println(server.address().getPort());
            Await.latch(new CountDownLatch(1)); // the server's own threads keep no process alive
        }
    }

    /** A base whose operator takes the boat at a port over, and which then does nothing more. */
    static final class BaseThatTakes implements BaseListener {
        private BaseThatTakes() {}

        public static void main(String[] args) {
            TcpBaseConfig config = TcpBaseConfig.of(ProxyConfig.DEFAULT.withClientId("second"), 1);
            TcpBase base = new TcpBase(config, SteadyClock.ofThisMachine(), new BaseThatTakes());
            base.connect(TcpTestFleet.port(Integer.parseInt(args[0])));
            Await.until(
                    "the boat says who has it",
                    () -> base.query(boats -> boats.find("anna")
                                    .filter(boat -> boat.status().pose().isPresent())
                                    .isPresent())
                            .join());
            System.out.println("takes");
            base.query(boats -> {
                        boats.find("anna").orElseThrow().handOver().takeCommand();
                        return true;
                    })
                    .join();
            Await.latch(new CountDownLatch(1));
        }

        @Override
        public Consumer<FleetEvent> found(String boatId) {
            return event -> {};
        }

        @Override
        public void onFailure(String what, RuntimeException cause) {
            throw new IllegalStateException(what, cause);
        }
    }
}
