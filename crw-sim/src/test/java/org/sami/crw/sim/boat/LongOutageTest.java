package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.sim.boat.TcpTestFleet.Base;

/** Outages that last, on real sockets; the clock of boats and bases runs five times as fast as the process. */
@Tag("long")
@Isolated("a list goes out again where the machine stands still for a second")
@Timeout(900)
class LongOutageTest {
    private static final int FAST = 5;

    @TempDir
    private Path logs;

    private TcpTestFleet fleet;

    /** How boats and bases are linked. */
    TestLinks links() {
        return TestLinks.plain();
    }

    @BeforeEach
    void open() {
        fleet = new TcpTestFleet(logs, LongOutageTest::clockMs, links());
    }

    @AfterEach
    void close() throws Exception {
        fleet.close();
    }

    @Test
    void routerThatIsOffForAMinuteLosesTwentyFiveBoatsAndAllGoOn() throws Exception {
        Base base = fleet.base("base");
        List<TestRelay> routers = new ArrayList<>();
        List<String> names = new ArrayList<>();
        for (int i = 1; i <= 25; i++) {
            names.add("boat" + i);
            routers.add(fleet.relay(fleet.boat("boat" + i)));
            base.tcp.connect(routers.get(i - 1).address());
        }
        for (String name : names) {
            base.linked(name);
            base.submit(name, TcpTestFleet.path("m1-" + name, 1));
        }
        names.forEach(name -> base.awaitMode(name, BoatMode.PATH));
        // On a machine that stands still for a second a list goes out again before the outage.
        Map<String, Long> uploaded = new HashMap<>();
        for (String name : names) {
            uploaded.put(name, fleet.executed(name, "upload"));
        }

        routers.forEach(router -> router.setSwallows(true));
        long off = clockMs();
        Await.until(
                "all lost",
                () -> names.stream().allMatch(name -> base.status(name).link() == LinkState.LOST));
        assertThat(clockMs() - off).as("ms").isGreaterThanOrEqualTo(3000L);
        Await.until("a minute", () -> clockMs() - off > 60_000);
        assertThat(names).allMatch(name -> base.status(name).link() == LinkState.LOST);
        assertThat(base.explanation("boat7")).contains("the link has been lost for");
        routers.forEach(router -> router.setSwallows(false));

        names.forEach(base::linked);
        names.forEach(name -> base.awaitMode(name, BoatMode.PATH));
        for (String name : names) {
            assertThat(fleet.executedIds(name)).doesNotHaveDuplicates();
            assertThat(fleet.executed(name, "upload")).isEqualTo(uploaded.get(name));
        }
        assertThat(base.failures).isEmpty();
    }

    @Test
    void whatComesThirtySecondsLateIsExecutedOnceAtMostAndTheNewestPathIsDriven() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        DelayingRelay relay = fleet.lateRelay(boat);
        Base base = fleet.base("base");
        base.connect(relay.address(), "anna");
        base.submit("anna", TcpTestFleet.path("first", 1));
        base.awaitMode("anna", BoatMode.PATH);

        relay.setDelayMs(30_000 / FAST);
        base.submit("anna", TcpTestFleet.path("second", 1, 1000));
        Await.until("lost", () -> base.status("anna").link() == LinkState.LOST);
        assertThat(base.explanation("anna")).contains("one command waits");
        Await.until("late frames have come", () -> relay.deliveredLate() > 0);
        base.submit("anna", TcpTestFleet.path("third", 1, 2000));
        relay.setDelayMs(0);

        Await.until("the newest is driven", () -> drives(base, "third#"));
        // On a busy machine the link is lost meanwhile, and the boat keeps its station until it is back.
        Await.holds("no earlier one comes back", 1.5, () -> holdsNoOther(base, "third#"));
        Await.until("the newest is driven still", () -> drives(base, "third#"));
        assertThat(fleet.executedIds("anna")).doesNotHaveDuplicates();
        assertThat(base.heldListId("anna")).isEqualTo(base.upload("anna").map(Upload::listId));
        assertThat(base.failures).isEmpty();
    }

    private static long clockMs() {
        return FAST * ProcessClock.ms();
    }

    private static boolean holdsNoOther(Base base, String list) {
        return base.heldListId("anna").map(id -> id.startsWith(list)).orElse(true);
    }

    private static boolean drives(Base base, String list) {
        Optional<Upload> upload = base.upload("anna");
        return upload.isPresent()
                && upload.get().listId().startsWith(list)
                && upload.get().state() == Upload.State.READ_BACK_EQUAL
                && base.mode("anna").equals(Optional.of(BoatMode.PATH));
    }
}
