package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.log.LogLines;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.TcpBase;
import org.sami.crw.proxy.tcp.TcpBaseConfig;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Real processes of {@code crw boat}, ended in order and by {@code kill -9}, and a base that commands them. */
@Tag("process")
@Timeout(900)
class BoatProcessTest {
    @TempDir
    private Path folder;

    private final List<CrwProcess> started = new ArrayList<>();
    private final AtomicReference<BoatStatus> status = new AtomicReference<>(BoatStatus.unknown("anna"));
    private final AtomicInteger restarts = new AtomicInteger();

    /** A process of the command, and the port that it printed. */
    private record Boat(CrwProcess process, int port) {}

    private Boat boat(int port, String... more) throws IOException {
        List<String> arguments =
                new ArrayList<>(List.of("boat", "--port", "" + port, "--name", "anna", "--at", "45.4,10.9"));
        arguments.addAll(List.of(more));
        CrwProcess process = CrwProcess.start(Files.createDirectories(folder.resolve("said")), arguments);
        started.add(process);
        return new Boat(process, Integer.parseInt(process.awaitOut("anna listens on 127.0.0.1:")));
    }

    @AfterEach
    void endProcesses() {
        started.forEach(CrwProcess::close);
    }

    private TcpBase base(int port) {
        return base("base", port, new Recorder());
    }

    private static TcpBase base(String clientId, int port, BaseListener listener) {
        TcpBaseConfig config = new TcpBaseConfig(
                ProxyConfig.DEFAULT.withClientId(clientId).withTelemetryHz(20), 1, 50, 1000, 20, 200, 256, 4 << 20);
        TcpBase base = new TcpBase(config, new SteadyClock(ProcessClock::ms), listener);
        base.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
        return base;
    }

    private static void tell(TcpBase base, Consumer<BoatProxy> what) {
        base.query(proxies -> {
                    what.accept(proxies.find("anna").orElseThrow());
                    return true;
                })
                .join();
    }

    private static FollowPath farAway(int points) {
        List<GeoPoint> path = new ArrayList<>();
        for (int i = 0; i < points; i++) {
            path.add(GeoPoint.of(45.5 + i * 1e-5, 10.9));
        }
        return FollowPath.of("m1-a1-anna", 1, 1, path, Priority.MEDIUM);
    }

    private List<String> executed() throws IOException {
        List<String> ids = new ArrayList<>();
        LogLines.read(
                folder.resolve("anna.log"), entry -> ids.add(entry.command().commandId()));
        return ids;
    }

    private boolean is(BoatMode mode) {
        return status.get().link() == LinkState.LINKED && status.get().mode().equals(Optional.of(mode));
    }

    /** Whatever its link, which a machine that stands still may lose. */
    private boolean isNothingBut(BoatMode mode) {
        return status.get().mode().filter(other -> other != mode).isEmpty();
    }

    @Test
    void signalEndsItInOrder() throws Exception {
        Boat boat = boat(0);
        boat.process.terminate();

        assertThat(boat.process.await(60)).isEqualTo(143); // as the system says it of SIGTERM
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void killedInMidPathItDoesNotMoveByItselfAndTheOperatorIsAsked(boolean withItsState) throws Exception {
        Boat boat = boat(0, "--log", folder.toString());
        try (TcpBase base = base(boat.port)) {
            until("linked", () -> status.get().link() == LinkState.LINKED);
            tell(base, proxy -> proxy.commands().submit(farAway(50)));
            until("under way", () -> is(BoatMode.PATH));
            boat.process.kill();
            until("lost", () -> status.get().link() == LinkState.LOST);
            assertThat(executed()).as("what was answered is in the log").hasSize(2);

            boat(boat.port, "--log", (withItsState ? folder : folder.resolve("new")).toString());
            until("the operator is asked", () -> restarts.get() == 1);
            until("it rests", () -> is(BoatMode.STOPPED));
            Await.holds("it rests", 1.5, () -> isNothingBut(BoatMode.STOPPED));
            tell(base, BoatProxy::confirmRestart);
            until("under way again", () -> is(BoatMode.PATH));
            assertThat(executed()).doesNotHaveDuplicates();
        }
    }

    @ParameterizedTest
    @CsvSource({"0, true", "3, true", "10, true", "30, true", "80, true", "3, false", "30, false"})
    void killedInMidUploadItHoldsAWholeListOrNone(long afterMs, boolean withItsState) throws Exception {
        Boat boat = boat(0, "--log", folder.toString());
        try (TcpBase base = base(boat.port)) {
            until("linked", () -> status.get().link() == LinkState.LINKED);
            tell(base, proxy -> proxy.commands().submit(farAway(5_000)));
            LockSupport.parkNanos(afterMs * 1_000_000);
            boat.process.kill();
            List<String> before = executed();

            boat(boat.port, "--log", (withItsState ? folder : folder.resolve("new")).toString());
            until("the operator is asked", () -> restarts.get() == 1);
            until("it rests", () -> is(BoatMode.STOPPED));
            until("it says what it holds", () -> held(base).isPresent());
            assertThat(held(base)).contains(before.isEmpty() || !withItsState ? "" : "m1-a1-anna#base.0.1");
            tell(base, BoatProxy::confirmRestart);
            until("under way", () -> is(BoatMode.PATH));
            assertThat(executed()).doesNotHaveDuplicates();
        }
    }

    private static Optional<String> held(TcpBase base) {
        return base.query(
                        proxies -> proxies.find("anna").orElseThrow().commands().heldListId())
                .join();
    }

    @Test
    void processThatStandsStillIsShownAsLostAndGoesOnOnceItIsHeardAgain() throws Exception {
        Boat boat = boat(0, "--log", folder.toString());
        try (TcpBase base = base(boat.port)) {
            until("linked", () -> status.get().link() == LinkState.LINKED);
            tell(base, proxy -> proxy.commands().submit(farAway(50)));
            until("under way", () -> is(BoatMode.PATH));
            long stoppedMs = ProcessClock.ms();
            signal(boat, "STOP"); // its socket stays open, and what is sent to it waits
            until("lost", () -> status.get().link() == LinkState.LOST);
            assertThat(ProcessClock.ms() - stoppedMs)
                    .as("ms; FleetLinksTest says it exactly: here the boat may have been heard some time before")
                    .isGreaterThan(1000);
            until("it has been still for longer", () -> ProcessClock.ms() - stoppedMs > 6_000);

            signal(boat, "CONT");
            until("under way again", () -> is(BoatMode.PATH));
            assertThat(restarts.get()).as("it is the same start of the boat").isZero();
            assertThat(executed()).doesNotHaveDuplicates();
        }
    }

    private static void signal(Boat boat, String name) throws Exception {
        Process kill = new ProcessBuilder("kill", "-" + name, "" + boat.process.pid()).start();
        assertThat(kill.waitFor()).isZero();
    }

    @Test
    void fleetStopStaysLatchedOverAKillAndIsReleasedByACommandAlone() throws Exception {
        Boat boat = boat(0, "--log", folder.toString());
        try (TcpBase base = base(boat.port)) {
            until("linked", () -> status.get().link() == LinkState.LINKED);
            tell(base, proxy -> proxy.commands().submit(farAway(50)));
            until("under way", () -> is(BoatMode.PATH));
            tell(base, BoatProxy::fleetStop);
            until("stopped", () -> is(BoatMode.FLEET_STOP));
            boat.process.kill();
            until("lost", () -> status.get().link() == LinkState.LOST);

            boat(boat.port, "--log", folder.toString());
            until("the operator is asked", () -> restarts.get() == 1);
            tell(base, BoatProxy::confirmRestart);
            until("it is still stopped", () -> is(BoatMode.FLEET_STOP));
            Await.holds("it is still stopped", 1.5, () -> isNothingBut(BoatMode.FLEET_STOP));
            tell(base, BoatProxy::fleetRelease);
            until("under way", () -> is(BoatMode.PATH));
            assertThat(executed()).doesNotHaveDuplicates();
        }
    }

    @ParameterizedTest
    @CsvSource({"return, RETURN", "CONTINUE, PATH", "drift, STOPPED"})
    void doesWhatItsOptionSaysWhenTheBaseIsGone(String action, BoatMode doing) throws Exception {
        Boat boat = boat(0, "--lost-link", action);
        Watcher watcher = new Watcher();
        try (TcpBase watching = base("watching", boat.port, watcher)) {
            until("it is watched", () -> !watcher.modes.isEmpty());
            try (TcpBase base = base(boat.port)) {
                until("linked", () -> status.get().link() == LinkState.LINKED);
                tell(base, proxy -> proxy.commands().submit(farAway(50)));
                until("under way", () -> is(BoatMode.PATH));
                until("some 8 m from home", () -> watcher.northOf(45.4) > 8 / 111_000.0);
            }
            boat.process.awaitErr(" is gone: ");

            double fromDeg = watcher.northOf(45.4);
            until(
                    "it does what the option says",
                    () -> watcher.sinceItWasUnderWay().contains(doing)
                            && (doing != BoatMode.PATH || watcher.northOf(45.4) > fromDeg + 8 / 111_000.0));
            assertThat(watcher.sinceItWasUnderWay()).startsWith(BoatMode.PATH);
            assertThat(watching.links().join()).hasSize(1);
        }
    }

    @Test
    void saysWhatIsWrongWithItsOptions() {
        assertThat(CommandResult.crw("boat", "--port", "0", "--name", "anna", "--at", "45,10", "--lost-link", "explode")
                        .err())
                .contains("--lost-link")
                .containsIgnoringCase("drift");
        assertThat(CommandResult.crw("boat", "--port", "0", "--name", "anna", "--at", "91,0")
                        .err())
                .contains("LAT,LON");
        assertThat(CommandResult.crw("boat", "--port", "70000", "--name", "anna", "--at", "45,10")
                        .exitCode())
                .isEqualTo(2);
        assertThat(CommandResult.crw("boat", "--port", "0", "--name", "../anna", "--at", "45,10")
                        .err())
                .contains("letters");
        assertThat(CommandResult.crw("boat", "--name", "anna", "--at", "45,10").err())
                .contains("--port");
    }

    @Test
    void leavesAloneWhatIsNoLogAndNoFolder() throws Exception {
        Files.writeString(folder.resolve("anna.log"), "my diary");
        CommandResult diary =
                CommandResult.crw("boat", "--port", "0", "--name", "anna", "--at", "45,10", "--log", folder.toString());
        String file = folder.resolve("anna.log").toString();
        CommandResult noFolder =
                CommandResult.crw("boat", "--port", "0", "--name", "anna", "--at", "45,10", "--log", file);

        assertThat(diary.exitCode()).isEqualTo(4);
        assertThat(diary.err()).contains("anna.log is no log of a boat");
        assertThat(folder.resolve("anna.log")).hasContent("my diary");
        assertThat(noFolder.exitCode()).isEqualTo(4);
        assertThat(noFolder.err()).contains("anna.log is no folder");
    }

    @Test
    void saysWhoCanCommandItWhenItIsReachedFromElsewhere() throws Exception {
        Path said = folder.resolve("said");
        Process process = CrwProcess.command(
                        folder,
                        List.of(
                                "boat",
                                "--port",
                                "0",
                                "--name",
                                "anna",
                                "--at",
                                "45.4,10.9",
                                "--bind",
                                "0.0.0.0",
                                "--open",
                                "--while-input"))
                .redirectError(said.toFile())
                .start();
        try {
            process.getOutputStream().close();
            assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
        } finally {
            process.destroyForcibly();
        }

        assertThat(Files.readAllLines(said))
                .containsOnlyOnce("anna: links are plain: whoever reaches the port commands it");
    }

    @Test
    void refusesToBeReachedFromElsewhereWithoutKeysUnlessThatIsMeant() {
        CommandResult refused =
                CommandResult.crw("boat", "--port", "0", "--name", "anna", "--at", "45.4,10.9", "--bind", "0.0.0.0");

        assertThat(refused.exitCode()).isEqualTo(2);
        assertThat(refused.err()).contains("whoever reaches 0.0.0.0 could command the boat", "--boat-keys", "--open");
    }

    @Test
    void saysThatItsPortIsTaken() throws Exception {
        Boat boat = boat(0);
        CommandResult second =
                CommandResult.crw("boat", "--port", "" + boat.port, "--name", "berta", "--at", "45.4,10.9");

        assertThat(second.exitCode()).isEqualTo(4);
        assertThat(second.err()).containsIgnoringCase("address already in use");
    }

    private static void until(String what, BooleanSupplier condition) {
        Await.until(what, condition);
    }

    /** Keeps the latest of what the base is told. */
    private final class Recorder implements BaseListener, Consumer<FleetEvent> {
        @Override
        public Consumer<FleetEvent> found(String boatId) {
            return this;
        }

        @Override
        public void accept(FleetEvent event) {
            if (event instanceof FleetEvent.StatusReported reported) {
                onStatus(reported.status());
            } else if (event instanceof FleetEvent.LinkChanged link) {
                onLinkChange(link.status());
            } else if (event instanceof FleetEvent.Restarted) {
                onRestarted();
            }
        }

        private void onStatus(BoatStatus news) {
            status.set(news);
        }

        private void onLinkChange(BoatStatus news) {
            status.set(news);
        }

        private void onRestarted() {
            restarts.incrementAndGet();
        }
    }

    /** Only watches the boat, and keeps its modes in their order. */
    private static final class Watcher implements BaseListener, Consumer<FleetEvent> {
        private final List<BoatMode> modes = new CopyOnWriteArrayList<>();
        private volatile double latDeg;

        @Override
        public Consumer<FleetEvent> found(String boatId) {
            return this;
        }

        @Override
        public void onBoat(BoatProxy proxy) {
            proxy.handOver().observe();
        }

        @Override
        public void accept(FleetEvent event) {
            if (event instanceof FleetEvent.StatusReported reported) {
                onStatus(reported.status());
            }
        }

        private void onStatus(BoatStatus news) {
            news.pose().ifPresent(pose -> latDeg = pose.position().latDeg());
            news.mode()
                    .filter(mode -> modes.isEmpty() || modes.get(modes.size() - 1) != mode)
                    .ifPresent(modes::add);
        }

        double northOf(double otherDeg) {
            return latDeg - otherDeg;
        }

        List<BoatMode> sinceItWasUnderWay() {
            List<BoatMode> until = List.copyOf(modes);
            return until.subList(Math.max(0, until.indexOf(BoatMode.PATH)), until.size());
        }
    }
}
