package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.crw.proxy.tcp.TcpBase;
import org.sami.crw.proxy.tcp.TcpBaseConfig;
import org.sami.crw.sim.boat.TcpTestFleet.Base;

/** Bases and simulated boats over real sockets: what is lost is shown, what comes back goes on, nothing is done twice. */
@Tag("long")
@Execution(ExecutionMode.CONCURRENT)
@Timeout(900)
class TcpBaseTest {
    @TempDir
    private Path logs;

    private TcpTestFleet fleet;

    /** How boats and bases are linked. */
    TestLinks links() {
        return TestLinks.plain();
    }

    @BeforeEach
    void open() {
        fleet = new TcpTestFleet(logs, links());
    }

    @AfterEach
    void close() throws Exception {
        fleet.close();
    }

    @Test
    void findsBoatsByTheirAddressesAndHasThemDriveTheirPaths() throws Exception {
        Base base = fleet.base("base");
        for (String name : List.of("anna", "berta")) {
            BoatOnTcp boat = fleet.boat(name);
            base.connect(boat.address(), name);
            base.submit(name, TcpTestFleet.path("m1-" + name, 1, 4, 8));
        }

        Await.until(
                "both are done",
                () -> base.count("anna completed m1-anna") == 1 && base.count("berta completed m1-berta") == 1);
        assertThat(base.links())
                .extracting(LinkReport::boatId)
                .containsExactly(Optional.of("anna"), Optional.of("berta"));
        assertThat(base.links()).allMatch(LinkReport::connected);
        assertThat(fleet.executedIds("anna"))
                .hasSize(2)
                .doesNotHaveDuplicates()
                .allMatch(id -> id.startsWith("m1-anna#base.0."));
        assertThat(base.failures).isEmpty();
    }

    @Test
    void aListenerThatFailsAtEverythingKeepsNoBoatFromItsPath() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        TestRelay relay = fleet.relay(boat);
        try (TcpBase base = new TcpBase(
                fleet.kindOfLinks().ofBase(TcpBaseConfig.of(ProxyConfig.DEFAULT.withTelemetryHz(10), 5)),
                new SteadyClock(ProcessClock::ms),
                new FailingListener())) {
            base.connect(relay.address());
            Await.until(
                    "anna is linked",
                    () -> base.query(boats -> boats.find("anna")
                                    .filter(found -> found.status().link() == LinkState.LINKED)
                                    .isPresent())
                            .join());
            relay.setSwallows(true);
            Await.until("the loss of the link is told", () -> link(base) == LinkState.LOST);
            relay.setSwallows(false);
            base.query(boats -> {
                        boats.find("anna").orElseThrow().commands().submit(TcpTestFleet.path("m1-anna", 1, 2));
                        return true;
                    })
                    .join();

            Await.until(
                    "anna is done",
                    () -> base.query(boats -> boats.find("anna").orElseThrow().isAtRest())
                            .join());
        }
        assertThat(fleet.executed("anna", "start")).isEqualTo(1);
    }

    private static LinkState link(TcpBase base) {
        return base.query(boats -> boats.find("anna").orElseThrow().status().link())
                .join();
    }

    /** Throws whatever it is told. */
    private static final class FailingListener implements BaseListener {
        @Override
        public Consumer<FleetEvent> found(String boatId) {
            return event -> {
                throw new IllegalStateException(event.toString());
            };
        }

        @Override
        public void onBoat(BoatProxy proxy) {
            throw new IllegalStateException("onBoat");
        }

        @Override
        public void onFailure(String what, RuntimeException cause) {
            throw new IllegalStateException("onFailure", cause);
        }
    }

    @Test
    void closedSocketIsShownAtOnceAndTheBoatGoesOnWithItsList() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        TestRelay relay = fleet.relay(boat);
        AtomicLong stoodStillAtMs = new AtomicLong(Long.MAX_VALUE);
        Base base = fleet.base("base", () -> Math.min(ProcessClock.ms(), stoodStillAtMs.get()));
        base.connect(relay.address(), "anna");
        base.submit("anna", TcpTestFleet.path("m1", 1));
        base.awaitMode("anna", BoatMode.PATH);
        stoodStillAtMs.set(ProcessClock.ms()); // no boat is silent for too long while no time passes
        relay.cut();

        Await.until("shown", () -> base.count("anna LOST") == 1);
        stoodStillAtMs.set(Long.MAX_VALUE);
        base.linked("anna");
        Await.until(
                "it goes on", () -> uploads("start") == 2 && base.mode("anna").equals(Optional.of(BoatMode.PATH)));
        assertThat(uploads("upload")).isEqualTo(1);
        assertThat(fleet.executedIds("anna")).doesNotHaveDuplicates();
    }

    @Test
    void linkThatIsCutOnPurposeStaysDownUntilItIsTakenUpAgain() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        Base base = fleet.base("base");
        base.connect(boat.address(), "anna");
        base.submit("anna", TcpTestFleet.path("m1", 1));
        base.awaitMode("anna", BoatMode.PATH);
        base.ask("anna", proxy -> {
            proxy.disconnect();
            return true;
        });

        Await.until("the boat is alone", () -> !base.links().get(0).connected());
        assertThat(base.ask("anna", BoatProxy::isDisconnected)).isTrue();
        long connections = base.links().get(0).connections();
        base.ask("anna", proxy -> {
            proxy.reconnect();
            return true;
        });
        base.awaitMode("anna", BoatMode.PATH);
        Await.until("it goes on", () -> base.links().get(0).connected() && uploads("start") == 2);
        assertThat(base.links().get(0).connections()).isEqualTo(connections + 1);
        assertThat(uploads("upload")).isEqualTo(1);
        assertThat(base.failures).isEmpty();
    }

    private long uploads(String type) {
        return executed("anna", type);
    }

    private long executed(String name, String type) {
        try {
            return fleet.executed(name, type);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void silentLinkIsShownLostWithinHalfASecondAfterItsTimeAndRecovers() throws Exception {
        AtomicLong backMs = new AtomicLong();
        BoatOnTcp boat = fleet.boat("anna");
        TestRelay relay = fleet.relay(boat);
        Base base = fleet.base("base", () -> ProcessClock.ms() - backMs.get());
        base.connect(relay.address(), "anna");
        base.submit("anna", TcpTestFleet.path("m1", 1));
        base.awaitMode("anna", BoatMode.PATH);
        Base watching = fleet.base("watching");
        watching.onlyWatches = true;
        watching.connect(boat.address(), "anna");
        relay.setSwallows(true);
        backMs.set(3_600_000); // and somebody sets the clock back

        long shownMs = Await.until("lost", () -> base.status("anna").link() == LinkState.LOST);
        assertThat(shownMs).as("ms; FleetLinksTest says it exactly").isGreaterThan(3300L);
        Await.until("the boat holds", () -> watching.mode("anna").equals(Optional.of(BoatMode.HOLD)));
        Await.holds("lost", 1, () -> base.status("anna").link() == LinkState.LOST);
        relay.setSwallows(false);

        base.linked("anna");
        Await.until("it goes on", () -> base.mode("anna").equals(Optional.of(BoatMode.PATH)));
        assertThat(uploads("upload")).isEqualTo(1);
        assertThat(fleet.executedIds("anna")).doesNotHaveDuplicates();
    }

    /** A name for threads that no test has which runs at the same time, also not the same test over links of another kind. */
    private String ownName(String name) {
        return name + "-" + getClass().getSimpleName().toLowerCase(Locale.ROOT) + "-";
    }

    @Test
    void hundredCutsLeaveNoThreadAndTheOtherBoatUntouched() throws Exception {
        String cutBoat = ownName("cutboat");
        String cutting = ownName("cutting");
        TestRelay relay = fleet.relay(fleet.boat(cutBoat));
        BoatOnTcp berta = fleet.boat("berta");
        Base base = fleet.base(cutting);
        base.connect(berta.address(), "berta");
        base.submit("berta", TcpTestFleet.path("m2", 2));
        base.awaitMode("berta", BoatMode.PATH);
        base.connect(relay.address(), cutBoat);
        long threads = Await.threads(cutting) + Await.threads(cutBoat);
        for (int i = 1; i <= 100; i++) {
            int times = i;
            relay.cut();
            Await.until("lost again", () -> base.count(cutBoat + " LOST") == times);
            Await.until("linked again", () -> base.count(cutBoat + " LINKED") == times + 1);
        }

        Await.until("no thread is left", () -> Await.threads(cutting) + Await.threads(cutBoat) <= threads);
        assertThat(base.count("berta LINKED")).isEqualTo(1);
        assertThat(base.count("berta LOST")).isZero();
        assertThat(fleet.executed("berta", "upload")).isEqualTo(1);
        assertThat(base.mode("berta")).contains(BoatMode.PATH);
        assertThat(base.failures).isEmpty();
    }

    @Test
    void closingTheBaseEndsItsThreads() throws Exception {
        String closing = ownName("closing");
        Base base = fleet.base(closing);
        base.connect(fleet.boat("anna").address(), "anna");
        base.tcp.connect(TcpTestFleet.port(1)); // nobody there
        base.close();

        Await.until("no thread is left", () -> Await.threads(closing) == 0);
    }

    @Test
    void ofTwoBoatsWithOneIdTheSecondIsRefusedAndAlarmedOnce() throws Exception {
        BoatOnTcp first = fleet.boat("anna");
        BoatOnTcp second = fleet.boat("anna", 0, logs.resolve("other"));
        Base base = fleet.base("base");
        base.connect(first.address(), "anna");
        base.submit("anna", TcpTestFleet.path("m1", 1));
        base.awaitMode("anna", BoatMode.PATH);
        base.tcp.connect(second.address());

        Await.until("several tries", () -> base.links().get(1).connections() >= 4);
        assertThat(base.alarms).singleElement().satisfies(alarm -> {
            assertThat(alarm.kind()).isEqualTo(LinkAlarm.Kind.TWO_BOATS_WITH_ONE_ID);
            assertThat(alarm.text()).contains(":" + second.address().getPort() + ";");
        });
        assertThat(base.links().get(1).boatId()).isEmpty();
        assertThat(base.count("anna LINKED")).isEqualTo(1);
        assertThat(base.mode("anna")).contains(BoatMode.PATH);
        List<Object> entries = new ArrayList<>();
        org.sami.boat.server.log.LogLines.read(logs.resolve("other").resolve("anna.log"), entries::add);
        assertThat(entries).as("what the refused boat was told").isEmpty();
    }

    @Test
    void oneBoatUnderTwoAddressesIsLinkedOnce() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        Base base = fleet.base("base");
        base.connect(boat.address(), "anna");
        base.tcp.connect(fleet.relay(boat).address());

        Await.until("an alarm", () -> !base.alarms.isEmpty());
        assertThat(base.alarms)
                .singleElement()
                .extracting(LinkAlarm::kind)
                .isEqualTo(LinkAlarm.Kind.ONE_BOAT_AT_TWO_ADDRESSES);
    }

    @Test
    void restartedBoatIsNotMovedBeforeTheOperatorAllowsItWithItsState() throws Exception {
        restart(logs);
    }

    @Test
    void restartedBoatIsNotMovedBeforeTheOperatorAllowsItWithoutItsState() throws Exception {
        restart(logs.resolve("empty"));
    }

    private void restart(Path logFolder) throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        int port = boat.address().getPort();
        Base base = fleet.base("base");
        base.connect(boat.address(), "anna");
        base.submit("anna", TcpTestFleet.path("m1", 1));
        base.awaitMode("anna", BoatMode.PATH);
        boat.close();
        Await.until("lost", () -> base.count("anna LOST") == 1);
        BoatOnTcp again = fleet.boat("anna", port, logFolder);
        assertThat(again.restored() > 0).isEqualTo(logFolder.equals(logs));

        Await.until("the operator is asked", () -> base.count("anna restarted") == 1);
        base.awaitMode("anna", BoatMode.STOPPED);
        Await.holds("it rests", 1.5, () -> base.mode("anna").equals(Optional.of(BoatMode.STOPPED)));
        assertThat(base.explanation("anna")).contains("started anew");
        base.ask("anna", proxy -> {
            proxy.confirmRestart();
            return true;
        });

        base.awaitMode("anna", BoatMode.PATH);
        assertThat(base.upload("anna").orElseThrow().state()).isEqualTo(Upload.State.READ_BACK_EQUAL);
        assertThat(fleet.executedIds("anna")).doesNotHaveDuplicates();
    }

    @Test
    void commandChangesHandsBetweenBasesAndComesBack() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        Base first = fleet.base("first");
        first.connect(boat.address(), "anna");
        first.submit("anna", TcpTestFleet.path("m1", 1));
        first.awaitMode("anna", BoatMode.PATH);
        Base second = fleet.base("second");
        second.connect(boat.address(), "anna");
        Await.until("it observes", () -> !second.ask("anna", BoatProxy::isCommanding));
        second.ask("anna", proxy -> {
            proxy.handOver().takeCommand();
            return true;
        });

        Await.until("the first is told", () -> first.count("anna observed") == 1);
        Await.until("the second is told", () -> second.count("anna commanded") == 1);
        assertThat(first.explanation("anna")).contains("another client commands");
        second.submit("anna", TcpTestFleet.path("m2", 2));
        Await.until("it does what the second wants", () -> uploads("upload") == 2 && uploads("start") == 2);

        first.ask("anna", proxy -> {
            proxy.handOver().askForCommand();
            return true;
        });
        Await.until("the second is asked", () -> second.count("anna asked for by first") == 1);
        second.ask("anna", proxy -> {
            proxy.handOver().grantCommand("first");
            return true;
        });
        Await.until("the first goes on", () -> uploads("start") == 3);
        Await.holds("nobody grabs it back", 1.5, () -> first.ask("anna", BoatProxy::isCommanding));
        assertThat(fleet.executedIds("anna")).doesNotHaveDuplicates();
    }

    @Test
    void routerThatIsOffLosesAllBoatsInTimeAndAllRecover() throws Exception {
        Base base = fleet.base("base");
        List<TestRelay> routers = new ArrayList<>();
        List<String> names = new ArrayList<>();
        for (int i = 1; i <= 25; i++) {
            String name = "boat" + i;
            TestRelay router = fleet.relay(fleet.boat(name));
            routers.add(router);
            names.add(name);
            base.tcp.connect(router.address());
        }
        for (String name : names) {
            base.linked(name);
            base.submit(name, TcpTestFleet.path("m1-" + name, 1));
        }
        names.forEach(name -> base.awaitMode(name, BoatMode.PATH));
        routers.forEach(router -> router.setSwallows(true));

        long shownMs = Await.until(
                "all lost",
                () -> names.stream().allMatch(name -> base.status(name).link() == LinkState.LOST));
        assertThat(shownMs).as("ms").isGreaterThan(3000L);
        routers.forEach(router -> router.setSwallows(false));
        names.forEach(base::linked);
        names.forEach(name -> base.awaitMode(name, BoatMode.PATH));
        for (String name : names) {
            assertThat(fleet.executedIds(name)).doesNotHaveDuplicates();
            assertThat(fleet.executed(name, "upload")).isEqualTo(1);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.2, 0.5})
    void uploadOverALossyLinkIsReadBackEqualOrFailsForAReason(double loss) throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        TestRelay relay = fleet.relay(boat);
        Base base = fleet.impatientBase("base", 100);
        base.connect(relay.address(), "anna");
        relay.setLoss(loss);
        double[] northM = new double[20];
        for (int i = 0; i < northM.length; i++) {
            northM[i] = 100 + 10 * i;
        }
        base.submit("anna", TcpTestFleet.path("m1", 1, northM));

        Await.until(
                "read back equal and started, or failed",
                () -> failed(base)
                        || (base.mode("anna").equals(Optional.of(BoatMode.PATH))
                                && base.upload("anna")
                                        .filter(upload -> upload.state() == Upload.State.READ_BACK_EQUAL)
                                        .isPresent()));
        assertThat(fleet.executedIds("anna")).doesNotHaveDuplicates();
        assertThat(loss < 0.5 && failed(base))
                .as("failed at a loss that can be borne")
                .isFalse();
    }

    private static boolean failed(Base base) {
        return base.heard.stream().anyMatch(line -> line.startsWith("anna failed m1: "));
    }

    @Test
    void tenThousandWaypointsAreReadBackEqual() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        Base base = fleet.base("base");
        base.connect(boat.address(), "anna");
        double[] northM = new double[10_000];
        for (int i = 0; i < northM.length; i++) {
            northM[i] = 100 + i * 0.37;
        }
        base.submit("anna", TcpTestFleet.path("m1", 1, northM));

        long ms = Await.until(
                "read back equal",
                () -> base.upload("anna")
                        .filter(upload -> upload.state() == Upload.State.READ_BACK_EQUAL)
                        .isPresent());
        assertThat(base.count("anna LOST") > 0 && ms < 3000)
                .as("lost within %s ms, without a silence of 3.5 s", ms)
                .isFalse();
    }

    /** What waits for the boat is bounded (256 frames or 1 MiB here): beyond that it is dropped, and nobody waits for it. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void boatThatReadsNothingOrOneByteASecondIsDroppedAndDelaysNoOther(int bytesPerSecond) throws Exception {
        BoatOnTcp berta = fleet.boat("berta");
        Base base = fleet.base("base");
        base.connect(berta.address(), "berta");
        try (UnreadingPeer stuck = new UnreadingPeer("anna", fleet.kindOfLinks().ofPeer("anna"), bytesPerSecond)) {
            base.connect(stuck.address(), "anna");
            List<Long> startedMs = new ArrayList<>();
            for (int i = 1; i <= 5; i++) {
                int times = i;
                base.submit("anna", TcpTestFleet.path("a" + i, i, new double[10_000]));
                base.submit("berta", TcpTestFleet.path("b" + i, 1));
                startedMs.add(Await.until("berta starts", () -> executed("berta", "start") == times));
            }

            assertThat(startedMs).as("ms").allMatch(ms -> ms < 5000);
            Await.until("the stuck one is dropped", () -> base.count("anna LOST") >= 1);
            assertThat(base.links().get(0).connections()).isEqualTo(1);
        }
    }
}
