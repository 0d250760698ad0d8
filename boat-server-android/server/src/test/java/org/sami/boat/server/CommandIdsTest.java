package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.Ack;
import org.sami.boat.link.AskForCommand;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.Hello;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.ServerTestBench.Client;

/** A command id counts for one client and one command; no id keeps a boat from being stopped. */
class CommandIdsTest {
    private static final List<Waypoint> PATH = List.of(new Waypoint(45.01, 10, 1));
    private static final List<Waypoint> OTHER_PATH = List.of(new Waypoint(45.02, 10, 1));

    private final ServerTestBench bench = new ServerTestBench();
    private final Client base = greet("base", Role.COMMANDER);

    private Client greet(String clientId, Role role) {
        Client client = bench.new Client();
        client.say(new Hello("", clientId, role, 1, ""));
        return client;
    }

    private void setUnderWay() {
        base.command(new UploadWaypoints("u", "l", PATH));
        assertThat(base.command(new StartWaypoints("go", "l", 0))).isInstanceOf(Ack.class);
        bench.run(1, base);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.PATH);
    }

    private static void assertTaken(LinkMessage answer) {
        assertThat(answer).isInstanceOf(Nack.class);
        assertThat(((Nack) answer).reason()).isEqualTo(NackReason.ID_TAKEN);
    }

    private static CommandMessage stop(String kind, String id) {
        return kind.equals("stop") ? new StopMotors(id) : new FleetStop(id);
    }

    private static BoatMode stopped(String kind) {
        return kind.equals("stop") ? BoatMode.STOPPED : BoatMode.FLEET_STOP;
    }

    @ParameterizedTest
    @ValueSource(strings = {"stop", "fleet-stop"})
    void stopIsExecutedThoughAnObserverHasUsedItsId(String kind) {
        setUnderWay();
        Client observer = greet("watcher", Role.OBSERVER);
        observer.say(new AskForCommand("x"));

        assertThat(base.command(stop(kind, "x"))).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).isEqualTo(stopped(kind));
    }

    @ParameterizedTest
    @ValueSource(strings = {"stop", "fleet-stop"})
    void stopIsExecutedThoughAnObserverHasUsedItsIdUnderTheNameOfTheCommander(String kind) {
        setUnderWay();
        greet("base", Role.OBSERVER).say(new AskForCommand("x"));

        assertThat(base.command(stop(kind, "x"))).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).isEqualTo(stopped(kind));
        assertThat(bench.log).contains("x ack");
    }

    @ParameterizedTest
    @ValueSource(strings = {"stop", "fleet-stop"})
    void stopIsExecutedThoughTheCommanderHasUsedItsIdForSomethingElse(String kind) {
        setUnderWay();

        assertThat(base.command(stop(kind, "go"))).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).isEqualTo(stopped(kind));
    }

    @ParameterizedTest
    @ValueSource(strings = {"stop", "fleet-stop"})
    void stopThatIsSentAgainStopsABoatThatMovesForSomebodyElse(String kind) {
        setUnderWay();
        base.command(stop(kind, "x"));
        Client other = greet("base2", Role.OBSERVER);
        other.say(new TakeCommand("take"));
        other.command(new FleetRelease("release"));
        other.command(new StartWaypoints("go on", "l", 0));
        assertThat(bench.server.mode()).isEqualTo(BoatMode.PATH);
        base.say(new TakeCommand("take back"));

        assertThat(base.command(stop(kind, "x"))).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).isEqualTo(stopped(kind));
    }

    @Test
    void copyOfAnEarlierStopFrameStopsNothingThatWasSentLater() {
        setUnderWay();
        byte[] stop = base.frame(100, new StopMotors("x"));
        base.hear(stop);
        base.say(101, new StartWaypoints("go on", "l", 0));

        assertThat(base.hear(stop).get(0)).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.PATH);
    }

    @Test
    void repeatedStopAfterALostLinkStopsABoatThatReturns() {
        setUnderWay();
        base.command(new StopMotors("x"));
        bench.run(4);
        assertThat(bench.server.mode()).isNotEqualTo(BoatMode.STOPPED);

        assertThat(base.command(new StopMotors("x"))).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
    }

    @Test
    void latchOfARepeatedFleetStopOutlivesARestart() {
        base.command(new FleetStop("f"));
        Client other = greet("base2", Role.OBSERVER);
        other.say(new TakeCommand("take"));
        other.command(new FleetRelease("release"));
        base.say(new TakeCommand("take back"));
        base.command(new FleetStop("f"));

        assertThat(bench.startedAnew().server.mode()).isEqualTo(BoatMode.FLEET_STOP);
    }

    @Test
    void differingCommandUnderAKnownIdIsRefusedAndChangesNothing() {
        base.command(new UploadWaypoints("u", "l", PATH));

        assertTaken(base.command(new UploadWaypoints("u", "l", OTHER_PATH)));
        assertTaken(base.command(new HoldPosition("u")));
        assertTaken(base.command(new TakeCommand("u")));
        assertThat(((HeldWaypoints) base.command(new ReadBack("r"))).waypoints())
                .isEqualTo(PATH);
        assertThat(base.command(new UploadWaypoints("u", "l", PATH)))
                .as("what was executed under the id is answered as before")
                .isInstanceOf(Ack.class);
    }

    @Test
    void differingCommandUnderAnIdOfAnEarlierStartIsRefused() {
        base.command(new UploadWaypoints("u", "l", PATH));
        ServerTestBench next = bench.startedAnew();
        Client again = next.new Client();
        again.say(new Hello("", "base", Role.COMMANDER, 1, ""));

        assertTaken(again.command(new UploadWaypoints("u", "l", OTHER_PATH)));
        assertThat(again.command(new UploadWaypoints("u", "l", PATH))).isInstanceOf(Ack.class);
    }

    @Test
    void idsOfOneClientAreNoneOfAnother() {
        base.command(new UploadWaypoints("u", "l", PATH));
        Client next = greet("base2", Role.OBSERVER);
        next.say(new TakeCommand("u"));

        assertThat(next.all(Nack.class)).isEmpty();
        assertThat(next.command(new UploadWaypoints("go", "l", OTHER_PATH))).isInstanceOf(Ack.class);
    }

    @Test
    void idsOfALogThatNamesNoClientAreThoseOfAllClients() {
        bench.server.restore("", new UploadWaypoints("old", "l", PATH), new Ack("old"));

        assertThat(base.command(new UploadWaypoints("old", "l", PATH))).isInstanceOf(Ack.class);
        assertTaken(base.command(new UploadWaypoints("old", "l", OTHER_PATH)));
    }

    @Test
    void manyWishesOfAnObserverMakeTheBoatForgetNoCommand() {
        setUnderWay();
        base.command(new HoldPosition("h"));
        Client observer = greet("watcher", Role.OBSERVER);
        for (int i = 0; i < 5000; i++) {
            observer.say(new TakeCommand("take" + i));
            base.say(new TakeCommand("back" + i));
            bench.nowMs += 100;
        }

        assertThat(base.command(new StartWaypoints("go", "l", 0))).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).as("it was executed before").isEqualTo(BoatMode.HOLD);
    }
}
