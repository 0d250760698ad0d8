package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.log.LogLines;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.crw.sim.boat.TcpTestFleet.Base;

/** Boats that change their address, come back under another one, or are removed from the base. */
@Execution(ExecutionMode.CONCURRENT)
@Timeout(900)
class MovedBoatTest {
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
    void boatThatFallsSilentAndAnswersAtAnotherAddressGoesOnThereWithoutAnAlarm() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        TestRelay first = fleet.relay(boat);
        TestRelay second = fleet.relay(boat);
        Base base = fleet.base("base");
        base.connect(first.address(), "anna");
        base.submit("anna", TcpTestFleet.path("m1", 1));
        base.awaitMode("anna", BoatMode.PATH);
        first.setSwallows(true); // its old connection stands and says nothing
        base.tcp.connect(second.address());

        Await.until(
                "it has moved",
                () -> base.count("anna moved to port " + second.address().getPort()) == 1);
        Await.until("it goes on", () -> fleet.executedOf("anna", "start") == 2);
        assertThat(base.alarms).isEmpty();
        assertThat(fleet.executedOf("anna", "upload")).isEqualTo(1);
        first.setSwallows(false);
        Await.holds("nobody tries the old address", 1, () -> base.links().size() == 1);
        assertThat(base.links()).extracting(LinkReport::address).containsExactly(second.address());
        assertThat(base.alarms).isEmpty();
        assertThat(base.failures).isEmpty();
    }

    @Test
    void boatThatStartsAnewAtAnotherAddressIsTakenOverAndNotMovedUntilItIsAllowed() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        Base base = fleet.base("base");
        base.connect(boat.address(), "anna");
        base.submit("anna", TcpTestFleet.path("m1", 1));
        base.awaitMode("anna", BoatMode.PATH);
        boat.close();
        BoatOnTcp again = fleet.boat("anna");
        base.tcp.connect(again.address());

        Await.until(
                "it has moved",
                () -> base.count("anna moved to port " + again.address().getPort()) == 1);
        Await.until("the operator is asked", () -> base.count("anna restarted") == 1);
        base.awaitMode("anna", BoatMode.STOPPED);
        Await.holds("it rests", 1, () -> base.mode("anna").equals(Optional.of(BoatMode.STOPPED)));
        assertThat(base.alarms).isEmpty();
        base.ask("anna", proxy -> {
            proxy.confirmRestart();
            return true;
        });
        base.awaitMode("anna", BoatMode.PATH);
        assertThat(fleet.executedIds("anna")).doesNotHaveDuplicates();
    }

    @Test
    void namesakeOfABoatThatHasComeBackIsAlarmed() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        TestRelay relay = fleet.relay(boat);
        BoatOnTcp namesake = fleet.boat("anna", 0, logs.resolve("other"));
        Base base = fleet.base("base");
        base.connect(relay.address(), "anna");
        relay.setSwallows(true);
        base.tcp.connect(namesake.address());
        Await.until(
                "it is taken for the same boat",
                () -> base.count("anna moved to port " + namesake.address().getPort()) == 1);
        relay.setSwallows(false);

        Await.until("the first is there again", () -> !base.alarms.isEmpty());
        assertThat(base.alarms)
                .singleElement()
                .extracting(LinkAlarm::kind)
                .isEqualTo(LinkAlarm.Kind.TWO_BOATS_WITH_ONE_ID);
    }

    @Test
    void secondBoatOfANameThatAppearsWhereAnotherBoatWasIsAlarmedOnceAndGetsNoCommand() throws Exception {
        BoatOnTcp anna = fleet.boat("anna");
        BoatOnTcp berta = fleet.boat("berta");
        int port = berta.address().getPort();
        Base base = fleet.base("base");
        base.connect(anna.address(), "anna");
        base.connect(berta.address(), "berta");
        base.submit("anna", TcpTestFleet.path("m1", 1));
        base.submit("berta", TcpTestFleet.path("m2", 2));
        base.awaitMode("anna", BoatMode.PATH);
        base.awaitMode("berta", BoatMode.PATH);
        berta.close();
        BoatOnTcp namesake = fleet.boat("anna", port, logs.resolve("other"));

        Await.until("an alarm", () -> !base.alarms.isEmpty());
        long connections = base.links().get(1).connections();
        Await.until("it is tried again", () -> base.links().get(1).connections() > connections + 1);
        assertThat(base.alarms).singleElement().satisfies(alarm -> {
            assertThat(alarm.kind()).isEqualTo(LinkAlarm.Kind.TWO_BOATS_WITH_ONE_ID);
            assertThat(alarm.text()).contains("two boats are named anna").contains(":" + port + ";");
        });
        assertThat(base.mode("anna")).contains(BoatMode.PATH);
        List<Object> entries = new ArrayList<>();
        LogLines.read(logs.resolve("other").resolve("anna.log"), entries::add);
        assertThat(entries).as("what the second was told").isEmpty();

        namesake.close();
        fleet.boat("berta", port, logs);
        Await.until("berta is there again", () -> base.count("berta restarted") == 1);
        assertThat(base.alarms).hasSize(1);
        assertThat(base.failures).isEmpty();
    }

    @Test
    void removedBoatIsStoppedAndLeftAloneAndItsCommandsFail() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        String removing =
                "removing-" + getClass().getSimpleName(); // the same test runs at the same time over other links
        Base base = fleet.base(removing);
        base.connect(boat.address(), "anna");
        base.submit("anna", TcpTestFleet.path("m1", 1));
        base.submit("anna", TcpTestFleet.path("m2", 2));
        base.awaitMode("anna", BoatMode.PATH);

        assertThat(base.tcp.remove("anna").join()).isTrue();
        assertThat(base.tcp.remove("anna").join()).isFalse();
        Await.until("it is stopped", () -> fleet.executedOf("anna", "stop") == 1);
        Await.until("no thread is left", () -> Await.threads(removing + "-to-") == 0);
        Await.until("its link is gone", () -> base.count("anna LOST") == 1);
        assertThat(base.heard)
                .contains(
                        "anna failed m1: the boat has been removed",
                        "anna failed m2: the boat has been removed",
                        "anna removed",
                        "anna LOST");
        assertThat(base.links()).isEmpty();
        assertThat(base.tcp.query(boats -> boats.boatIds()).join()).isEmpty();
        assertThat(base.failures).isEmpty();
    }

    @Test
    void removedBoatCanBeConnectedAgainAndGetsNoIdTwice() throws Exception {
        BoatOnTcp boat = fleet.boat("anna");
        Base base = fleet.base("base");
        for (int i = 1; i <= 3; i++) {
            int times = i;
            base.tcp.connect(boat.address());
            Await.until(
                    "it is there",
                    () -> base.tcp
                            .query(boats -> boats.find("anna").isPresent())
                            .join());
            base.submit("anna", TcpTestFleet.path("m1", 1));
            Await.until(
                    "it is under way",
                    () -> fleet.executedOf("anna", "start") == times
                            && base.ask("anna", BoatProxy::explain).shouldMove());
            assertThat(base.tcp.disconnect(boat.address()).join()).isTrue();
            Await.until("it is stopped", () -> fleet.executedOf("anna", "stop") == times);
        }

        assertThat(fleet.executedIds("anna")).doesNotHaveDuplicates();
        assertThat(base.alarms).isEmpty();
        assertThat(base.tcp.disconnect(boat.address()).join()).isFalse();
    }

    @Test
    void addressWhereNobodyIsCanBeGivenUp() throws IOException {
        Base base = fleet.base("base");
        base.tcp.connect(TcpTestFleet.port(1));
        assertThat(base.links()).hasSize(1);

        assertThat(base.tcp.disconnect(TcpTestFleet.port(1)).join()).isTrue();
        assertThat(base.links()).isEmpty();
    }
}
