package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.Hello;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.Nack;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.ServerTestBench.Client;

/** What was sent before a stop never moves the boat after it, by whatever way and however late it comes. */
class StaleMotionTest {
    private static final List<Waypoint> PATH = List.of(new Waypoint(45.01, 10, 1.5));

    private final ServerTestBench bench = new ServerTestBench();

    private Client withList() {
        Client client = bench.commander();
        client.command(new UploadWaypoints("u", "l", PATH));
        return client;
    }

    private static Hello hello() {
        return new Hello("boat1", "test", Role.COMMANDER, 1, "");
    }

    private void assertStays(BoatMode mode) {
        bench.run(0.1);
        assertThat(bench.server.mode()).isEqualTo(mode);
        assertThat(bench.vehicle.isResting()).isTrue();
    }

    @Test
    void settingByHandThatIsOlderThanAStopIsDropped() {
        Client client = withList();
        client.say(20, new StopMotors("x"));
        client.say(19, new Teleoperate(1, 0));

        assertStays(BoatMode.STOPPED);
        client.say(21, new Teleoperate(1, 0));
        assertThat(bench.server.mode()).isEqualTo(BoatMode.TELEOPERATION);
    }

    @Test
    void startThatIsOlderThanASettingByHandIsRefused() {
        Client client = withList();
        client.say(20, new Teleoperate(0, 0));

        assertThat(client.say(19, new StartWaypoints("late", "l", 0)).get(0)).isInstanceOf(Nack.class);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.TELEOPERATION);
    }

    @Test
    void startThatIsOlderThanAStopIsRefusedThoughAHelloCameBetween() {
        Client client = withList();
        client.say(20, new StopMotors("x"));
        client.say(21, hello());

        assertThat(client.say(19, new StartWaypoints("late", "l", 0)).get(0)).isInstanceOf(Nack.class);
        client.say(18, new Teleoperate(1, 0));
        assertStays(BoatMode.STOPPED);
    }

    @Test
    void startOverAnEarlierLinkIsRefusedThoughThatLinkSaysHelloAgain() {
        Client earlier = withList();
        byte[] hello = earlier.frame(8, hello());
        byte[] start = earlier.frame(9, new StartWaypoints("late", "l", 0));
        byte[] hand = earlier.frame(10, new Teleoperate(1, 0));
        bench.run(4); // a router holds back what the earlier link carries
        Client later = bench.commander();
        later.command(new HoldPosition("h"));
        later.command(new StopMotors("x"));
        later.say(new Hello("boat1", "test", Role.OBSERVER, 1, ""));
        later.session.closed(bench.nowMs);
        BoatMode before = bench.server.mode();

        earlier.hear(hello);
        assertThat(earlier.hear(start).get(0)).isInstanceOf(Nack.class);
        earlier.hear(hand);
        assertThat(bench.server.mode()).isEqualTo(before);
        assertThat(earlier.command(new StartWaypoints("new", "l", 0)))
                .as("what is sent after the welcome")
                .isInstanceOf(Ack.class);
    }

    @Test
    void releaseOfAFleetStopThatIsOlderThanTheFleetStopDoesNotReleaseIt() {
        Client client = withList();
        client.say(10, new FleetStop("f"));
        client.say(12, new FleetStop("g"));
        client.say(13, hello());
        client.say(11, new FleetRelease("r"));

        assertStays(BoatMode.FLEET_STOP);
    }

    @Test
    void releaseThatIsOlderThanAnObserversStopDoesNotReleaseABoatThatWasStoppedAlready() {
        Client client = withList();
        Client observer = bench.client(Role.OBSERVER, 1);
        client.command(new FleetStop("f"));
        byte[] release = client.frame(20, new FleetRelease("r"));

        assertThat(observer.command(new FleetStop("g"))).isInstanceOf(Ack.class);

        assertThat(client.hear(release).get(0)).isInstanceOf(Nack.class);
        assertStays(BoatMode.FLEET_STOP);
        assertThat(client.say(21, new FleetRelease("s")).get(0))
                .as("what is sent after the stop is known")
                .isInstanceOf(Ack.class);
    }

    @Test
    void repeatedStopOfAnObserverRefusesNoReleaseThatWasOrderedAfterIt() {
        Client client = withList();
        Client observer = bench.client(Role.OBSERVER, 1);
        observer.command(new FleetStop("g"));
        byte[] release = client.frame(20, new FleetRelease("r"));

        assertThat(observer.command(new FleetStop("g")))
                .as("as its answer was lost")
                .isInstanceOf(Ack.class);

        assertThat(client.hear(release).get(0)).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
    }

    @Test
    void holdThatIsOlderThanAStopDoesNotTurnTheMotorsOnAndStillEndsAWay() {
        Client client = withList();
        client.say(20, new StopMotors("x"));
        assertThat(client.say(19, new HoldPosition("late")).get(0)).isInstanceOf(Nack.class);
        assertStays(BoatMode.STOPPED);

        client.say(21, new StartWaypoints("s", "l", 0));
        assertThat(client.say(18, new HoldPosition("later")).get(0)).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.HOLD);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void nothingThatIsOlderThanAStopMovesTheBoatInAnyOrderOverAnyLinkAndAfterRestarts(long seed) {
        List<String> moved = new ArrayList<>();
        long stops = 0;
        long motions = 0;
        for (int round = 0; round < 250; round++) {
            DelayedFrames frames = new DelayedFrames(seed * 1000 + round, PATH);
            frames.play(300);
            moved.addAll(frames.faults());
            stops += frames.stops();
            motions += frames.motions();
        }

        assertThat(moved).isEmpty();
        assertThat(stops).as("stops that were executed").isGreaterThan(500);
        assertThat(motions).as("motions that were executed").isGreaterThan(300);
    }
}
