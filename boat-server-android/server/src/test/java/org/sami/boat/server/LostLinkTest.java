package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.boat.server.BoatsInModes.PATH;
import static org.sami.boat.server.BoatsInModes.boatIn;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.GrantCommand;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Role;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.server.ServerTestBench.Client;

/** What a boat does by itself when its commander's link is lost: every action that can be set, in every mode. */
class LostLinkTest {
    /** How a link ends: nothing comes any more, or the socket closes. */
    enum End {
        SILENT,
        CLOSED
    }

    static Stream<Arguments> everyModeActionAndEnd() {
        List<Arguments> rows = new ArrayList<>();
        for (BoatMode mode : BoatMode.values()) {
            for (LostLinkAction action : LostLinkAction.values()) {
                for (End end : End.values()) {
                    rows.add(Arguments.of(mode, action, end));
                }
            }
        }
        return rows.stream();
    }

    private static BoatMode expected(BoatMode before, LostLinkAction action) {
        if (before == BoatMode.FLEET_STOP) {
            return BoatMode.FLEET_STOP;
        }
        return switch (action) {
            case HOLD -> BoatMode.HOLD;
            case RETURN -> BoatMode.RETURN;
            case CONTINUE -> before == BoatMode.PATH ? BoatMode.PATH : BoatMode.HOLD;
            case DRIFT -> BoatMode.STOPPED;
        };
    }

    @ParameterizedTest
    @EnumSource(LostLinkAction.class)
    void boatThatWasStartedAnewIsMovedByNoLostLinkBeforeACommandHasMovedIt(LostLinkAction action) {
        ServerTestBench bench = new ServerTestBench();
        Client before = bench.commander();
        before.command(new UploadWaypoints("u", "l1", PATH));
        before.command(new SetLostLinkAction("a", action));
        before.command(new StartWaypoints("g", "l1", 0));
        ServerTestBench anew = bench.startedAnew();
        for (End end : End.values()) {
            Client client = anew.commander();
            anew.run(end == End.SILENT ? 5 : 1);
            client.session.closed(anew.nowMs);
            anew.vehicle.northM += 20; // it drifts
            anew.run(2);

            assertThat(anew.server.mode()).isEqualTo(BoatMode.STOPPED);
            assertThat(anew.vehicle.isResting()).isTrue();
        }
    }

    @ParameterizedTest
    @MethodSource("everyModeActionAndEnd")
    void doesWhatIsSetInEveryModeAtTheTimeThatIsSet(BoatMode mode, LostLinkAction action, End end) {
        ServerTestBench bench =
                new ServerTestBench(config -> config.deadmanMs(60_000)); // so that the link goes before the hand does
        Client client = boatIn(mode, bench);
        client.command(new SetLostLinkAction("a", action));
        assertThat(bench.server.mode()).isEqualTo(mode);

        if (end == End.CLOSED) {
            client.session.closed(bench.nowMs);
        } else {
            bench.run(3.5);
            assertThat(bench.server.mode()).as("3.5 s after the last frame").isEqualTo(mode);
            assertThat(bench.server.hasCommander()).isTrue();
            bench.run(0.1);
        }

        assertThat(bench.server.mode()).isEqualTo(expected(mode, action));
        assertThat(bench.server.hasCommander()).isFalse();
        bench.run(0.1);
        boolean drives = bench.server.mode() == BoatMode.PATH || bench.server.mode() == BoatMode.RETURN;
        assertThat(bench.vehicle.isResting()).isEqualTo(!drives);
    }

    @ParameterizedTest
    @EnumSource(LostLinkAction.class)
    void handThatFallsSilentStopsTheMotorsFirstAndThenCountsAsALostLink(LostLinkAction action) {
        ServerTestBench bench = new ServerTestBench();
        Client client = boatIn(BoatMode.TELEOPERATION, bench);
        client.command(new SetLostLinkAction("a", action));
        bench.run(1.9);
        assertThat(bench.vehicle.thrust()).isPositive();

        bench.run(0.1);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
        assertThat(bench.vehicle.isResting()).isTrue();
        bench.run(1.5);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
        bench.run(0.1);

        assertThat(bench.server.mode()).isEqualTo(expected(BoatMode.STOPPED, action));
    }

    @ParameterizedTest
    @EnumSource(LostLinkAction.class)
    void linkThatComesBackChangesNothingUntilACommandDoes(LostLinkAction action) {
        ServerTestBench bench = new ServerTestBench();
        Client client = boatIn(BoatMode.PATH, bench);
        client.command(new SetLostLinkAction("a", action));
        bench.run(4);
        BoatMode doing = bench.server.mode();

        client.say(new Hello("boat1", "test", Role.COMMANDER, 1, ""));
        bench.run(10, client);
        assertThat(bench.server.mode()).isEqualTo(doing);
        assertThat(client.command(new StartWaypoints("on", "l1", 0))).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.PATH);
    }

    @Test
    void boatThatKeepsAStationKeepsThatOneAndAnyOtherTheOneWhereItIs() {
        ServerTestBench bench = new ServerTestBench();
        Client client = boatIn(BoatMode.HOLD, bench);
        bench.vehicle.northM = 46; // drifted, but not out of its radius
        client.session.closed(bench.nowMs);
        bench.vehicle.northM = 43;
        bench.run(0.1);
        assertThat(bench.vehicle.thrust()).as("back to 50 m north").isPositive();

        ServerTestBench other = new ServerTestBench();
        Client stopped = boatIn(BoatMode.STOPPED, other);
        other.vehicle.northM = 46;
        stopped.session.closed(other.nowMs);
        other.vehicle.northM = 43;
        other.run(0.1);
        assertThat(other.vehicle.isResting()).as("3 m from where it was").isTrue();
    }

    @Test
    void returnsHomeAndKeepsStationThere() {
        ServerTestBench bench = new ServerTestBench();
        Client client = bench.commander();
        client.command(new SetLostLinkAction("a", LostLinkAction.RETURN));
        client.command(new HoldPosition("h"));
        bench.vehicle.eastM = 40;
        client.session.closed(bench.nowMs);
        bench.run(1);
        assertThat(bench.vehicle.rudder()).isEqualTo(-1);

        bench.vehicle.eastM = 2;
        bench.run(0.1);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.HOLD);
        assertThat(bench.vehicle.isResting()).isTrue();
    }

    @Test
    void fleetStopStaysLatchedWhileTheLinkIsLostAndRegained() {
        ServerTestBench bench = new ServerTestBench();
        Client client = boatIn(BoatMode.PATH, bench);
        client.command(new SetLostLinkAction("a", LostLinkAction.RETURN));
        client.command(new FleetStop("f"));
        client.session.closed(bench.nowMs);
        bench.run(5);
        Client next = bench.commander();
        next.say(new Teleoperate(1, 0));
        bench.run(1, next);

        assertThat(next.command(new StartWaypoints("g2", "l1", 0)))
                .isInstanceOfSatisfying(
                        Nack.class, nack -> assertThat(nack.reason()).isEqualTo(NackReason.FLEET_STOPPED));
        assertThat(bench.vehicle.isResting()).isTrue();
        next.command(new FleetRelease("r"));
        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
    }

    @Test
    void closedSessionIsNotHeardAnyMore() {
        ServerTestBench bench = new ServerTestBench();
        Client client = boatIn(BoatMode.PATH, bench);
        client.session.closed(bench.nowMs);

        assertThat(client.say(new StartWaypoints("late", "l1", 0))).isEmpty();
        assertThat(bench.server.mode()).isEqualTo(BoatMode.HOLD);
    }

    @Test
    void whatOthersSayDoesNotMaskALostCommander() {
        ServerTestBench bench = new ServerTestBench();
        Client commander = boatIn(BoatMode.PATH, bench);
        Client observer = bench.client(Role.OBSERVER, 10);
        Client namesake = bench.client(Role.COMMANDER, 10); // same client id, but the command is not free
        Client unknown = bench.new Client();
        bench.run(3.6, observer, namesake, unknown);

        assertThat(bench.server.mode()).isEqualTo(BoatMode.HOLD);
        assertThat(bench.server.hasCommander()).isFalse();
        assertThat(commander.session.role()).contains(Role.COMMANDER);
    }

    @Test
    void observerThatIsSilentItselfCannotBeMadeAMaskByAGrant() {
        ServerTestBench bench = new ServerTestBench();
        Client commander = boatIn(BoatMode.PATH, bench);
        Client observer = bench.new Client();
        observer.say(new Hello("boat1", "other", Role.OBSERVER, 1, ""));
        bench.run(10, commander);
        commander.command(new GrantCommand("grant", "other"));
        assertThat(observer.session.role()).contains(Role.COMMANDER);
        bench.run(0.1, commander);

        assertThat(bench.server.mode()).isEqualTo(BoatMode.HOLD);
    }

    @Test
    void whatWaitedWhileTheBoatsProcessStoodStillIsAsLateAsAnythingElse() {
        ServerTestBench bench = new ServerTestBench();
        Client client = boatIn(BoatMode.HOLD, bench);
        bench.run(1, client);
        bench.nowMs += 30_000; // no tick in between: the phone slept
        client.say(new Heartbeat(1));

        assertThat(client.command(new StartWaypoints("late", "l1", 0)))
                .isInstanceOfSatisfying(
                        Nack.class, nack -> assertThat(nack.reason()).isEqualTo(NackReason.NOT_GREETED));
        client.say(new Teleoperate(1, 0));
        bench.run(0.1);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.HOLD);
        assertThat(bench.vehicle.isResting()).isTrue();
    }

    @Test
    void timesAreTheBoatsOwnWhateverTheClientsClockSays() {
        ServerTestBench bench = new ServerTestBench();
        Client client = boatIn(BoatMode.PATH, bench);
        for (int i = 0; i < 100; i++) {
            client.say(new Heartbeat(i % 2 == 0 ? 0 : Long.MAX_VALUE));
            bench.run(0.1);
        }

        assertThat(bench.server.mode()).isEqualTo(BoatMode.PATH);
        List<Telemetry> telemetry = client.all(Telemetry.class);
        assertThat(telemetry.get(telemetry.size() - 1).boatTimeMs()).isGreaterThan(10_000);
    }
}
