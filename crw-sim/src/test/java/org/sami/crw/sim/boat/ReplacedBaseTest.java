package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.sim.boat.TcpTestFleet.Base;

/** A base that was cut off and replaced does not command again before its operator takes the boat over, also after the boat was restarted. */
@Execution(ExecutionMode.CONCURRENT)
@Timeout(900)
class ReplacedBaseTest {
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

    private static void take(Base base) {
        base.ask("anna", proxy -> {
            proxy.handOver().takeCommand();
            return true;
        });
        Await.until("it commands", () -> base.ask("anna", BoatProxy::isCommanding));
    }

    private static void assertReplaced(Base first) {
        Await.until(
                "the first is refused",
                () -> first.heard.stream().anyMatch(line -> line.contains("second has the command")));
        Await.holds("the first does not command", 1.5, () -> !first.ask("anna", BoatProxy::isCommanding));
        assertThat(first.explanation("anna")).contains("this base was replaced by second");
    }

    @Test
    void baseThatWasReplacedWhileItsLinkWasDownIsRefusedWhenItComesBack() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        TestRelay router = fleet.relay(boat);
        Base first = fleet.base("first");
        first.connect(router.address(), "anna");
        Await.until("the first commands", () -> first.ask("anna", BoatProxy::isCommanding));
        first.submit("anna", TcpTestFleet.path("m1", 1));
        first.awaitMode("anna", BoatMode.PATH);
        router.setSwallows(true);
        Await.until("the loss is told", () -> first.status("anna").link() == LinkState.LOST);
        Base second = fleet.base("second");
        second.connect(boat.address(), "anna");
        take(second);
        second.submit("anna", TcpTestFleet.path("m2", 2));
        second.awaitMode("anna", BoatMode.PATH);
        second.close();

        router.setSwallows(false);

        assertReplaced(first);
        long starts = fleet.executed("anna", "start");
        take(first);
        Await.until("it goes on", () -> fleet.executedOf("anna", "start") > starts);
    }

    @Test
    void boatThatWasStartedAnewStillRefusesTheReplacedBase() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        Base first = fleet.base("first");
        first.connect(boat.address(), "anna");
        Await.until("the first commands", () -> first.ask("anna", BoatProxy::isCommanding));
        Base second = fleet.base("second");
        second.connect(boat.address(), "anna");
        take(second);
        Await.until("the first observes", () -> !first.ask("anna", BoatProxy::isCommanding));
        second.close();
        int port = boat.address().getPort();
        boat.close();
        Await.until("the loss is told", () -> first.status("anna").link() == LinkState.LOST);

        fleet.boat("anna", port, logs);
        first.linked("anna");
        first.ask("anna", proxy -> {
            proxy.handOver().askForCommand();
            return true;
        });

        Await.holds("the first does not command", 1.5, () -> !first.ask("anna", BoatProxy::isCommanding));
        take(first);
    }

    @Test
    void baseThatOnlyWatchesStopsTheBoatAndTheCommanderKeepsItsCommand() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        Base first = fleet.base("first");
        first.connect(boat.address(), "anna");
        first.submit("anna", TcpTestFleet.path("m1", 1));
        first.awaitMode("anna", BoatMode.PATH);
        Base second = fleet.base("second");
        second.connect(boat.address(), "anna");
        assertThat(second.ask("anna", BoatProxy::isCommanding)).isFalse();

        second.ask("anna", proxy -> {
            proxy.fleetStop();
            return true;
        });

        first.awaitMode("anna", BoatMode.FLEET_STOP);
        assertThat(first.ask("anna", BoatProxy::isCommanding)).isTrue();
        assertThat(first.explanation("anna")).contains("stopped by second");
    }

    @Test
    void releaseThatWasOrderedBeforeAnotherBaseStoppedTheBoatDoesNotUndoThatStop() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        TestRelay router = fleet.relay(boat);
        Base first = fleet.base("first");
        first.connect(router.address(), "anna");
        Await.until("the first commands", () -> first.ask("anna", BoatProxy::isCommanding));
        first.submit("anna", TcpTestFleet.path("m1", 1));
        first.awaitMode("anna", BoatMode.PATH);
        Base second = fleet.base("second");
        second.connect(boat.address(), "anna");
        tell(first, BoatProxy::fleetStop);
        first.awaitMode("anna", BoatMode.FLEET_STOP);
        router.setSwallows(true);
        tell(first, BoatProxy::fleetRelease);
        Await.until("the loss is told", () -> first.status("anna").link() == LinkState.LOST);

        tell(second, BoatProxy::fleetStop);
        Await.until("the boat has the stop", () -> !second.ask("anna", BoatProxy::isAwaitingFleetAnswer));
        router.setSwallows(false);

        Await.until("the first commands again", () -> first.ask("anna", BoatProxy::isCommanding));
        Await.holds(
                "the boat stays stopped",
                2.5,
                () -> second.status("anna")
                        .mode()
                        .filter(BoatMode.FLEET_STOP::equals)
                        .isPresent());
        tell(first, BoatProxy::fleetRelease);
        first.awaitMode("anna", BoatMode.PATH);
    }

    private static void tell(Base base, Consumer<BoatProxy> what) {
        base.ask("anna", proxy -> {
            what.accept(proxy);
            return true;
        });
    }
}
