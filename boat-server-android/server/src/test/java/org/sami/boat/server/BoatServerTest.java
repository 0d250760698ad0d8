package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.Hello;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.Role;
import org.sami.boat.link.SetGains;
import org.sami.boat.link.SetVelocityMultiplier;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.ServerTestBench.Client;
import org.sami.boat.server.vehicle.LocalFrame;

class BoatServerTest {
    private static final List<Waypoint> PATH = List.of(new Waypoint(45.001, 10, 1.5), new Waypoint(45.002, 10, 1.6));

    private final ServerTestBench bench = new ServerTestBench();

    @Test
    void welcomesAClientAndSaysWhatItHolds() {
        Client client = bench.commander();

        assertThat(client.got)
                .extracting(LinkMessage::type)
                .containsExactly("welcome", "battery", "settings", "progress");
        Welcome welcome = client.all(Welcome.class).get(0);
        assertThat(welcome.bootId()).isEqualTo("boot7");
        assertThat(welcome.role()).isEqualTo(Role.COMMANDER);
        assertThat(client.all(Progress.class).get(0).listId()).isEmpty();
    }

    @Test
    void refusesAClientThatMeansAnotherBoat() {
        Client client = bench.new Client();

        assertThat(client.say(new Hello("boat2", "test", Role.COMMANDER, 1, "")))
                .singleElement()
                .isInstanceOf(Goodbye.class);
        assertThat(bench.server.hasCommander()).isFalse();
        assertNack(client.command(new StopMotors("c")), NackReason.NOT_GREETED);
    }

    @Test
    void oneCommandsAndTheOthersObserve() {
        Client commander = bench.commander();
        Client second = bench.commander();

        assertThat(second.all(Welcome.class).get(0).role()).isEqualTo(Role.OBSERVER);
        assertNack(second.command(new StopMotors("c0")), NackReason.NOT_COMMANDER);
        assertThat(commander.command(new FleetStop("c1"))).isInstanceOf(Ack.class);
        bench.run(3, commander, second);
        assertThat(second.all(Telemetry.class)).hasSize(3);
    }

    @Test
    void anotherMayCommandOnceTheCommanderIsLost() {
        Client lost = bench.commander();
        bench.run(4);
        Client next = bench.commander();

        assertThat(next.all(Welcome.class).get(0).role()).isEqualTo(Role.COMMANDER);
        assertNack(lost.command(new HoldPosition("c")), NackReason.NOT_COMMANDER);
    }

    @Test
    void replacesAListWholeReadsItBackAndStartsIt() {
        Client client = bench.commander();

        assertThat(client.command(new UploadWaypoints("c1", "l1", PATH))).isInstanceOf(Ack.class);
        HeldWaypoints held = (HeldWaypoints) client.command(new ReadBack("c2"));
        assertThat(held.listId()).isEqualTo("l1");
        assertThat(held.waypoints()).isEqualTo(PATH);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
        assertNack(client.command(new StartWaypoints("c3", "other", 0)), NackReason.UNKNOWN_LIST);
        assertNack(client.command(new StartWaypoints("c4", "l1", 3)), NackReason.BAD_INDEX);
        assertThat(client.command(new StartWaypoints("c5", "l1", 0))).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.PATH);
    }

    @Test
    void keepsTheOldListWhenTheNewOneIsRefused() {
        ServerTestBench small = new ServerTestBench(config -> config.maxWaypoints(2));
        Client client = small.commander();
        client.command(new UploadWaypoints("c1", "l1", PATH));
        client.command(new StartWaypoints("c2", "l1", 0));
        small.run(1, client);

        assertNack(
                client.command(new UploadWaypoints("c3", "l2", Collections.nCopies(3, PATH.get(0)))),
                NackReason.TOO_LONG);
        String bad =
                "{\"type\":\"upload\",\"seq\":9,\"command\":\"c4\",\"list\":\"l3\",\"waypoints\":[[1,1,1],[99,1,1]]}";
        client.session.receive(FrameBytes.of(bad), small.nowMs);

        Nack nack = client.all(Nack.class).get(1);
        assertThat(nack.commandId()).isEqualTo("c4");
        assertThat(nack.reason()).isEqualTo(NackReason.MALFORMED);
        assertThat(nack.detail()).contains("/waypoints/1");
        assertThat(client.session.refusedFrames()).isEqualTo(1);
        assertThat(((HeldWaypoints) client.command(new ReadBack("c5"))).waypoints())
                .isEqualTo(PATH);
        assertThat(small.server.mode()).isEqualTo(BoatMode.PATH);
    }

    @Test
    void boatOnItsWayKeepsStationWhenItsListIsReplaced() {
        Client client = driving();

        client.command(new UploadWaypoints("n1", "l2", PATH));
        bench.run(0.1, client);

        assertThat(bench.server.mode()).isEqualTo(BoatMode.HOLD);
        assertThat(bench.vehicle.isResting()).isTrue();
    }

    @Test
    void reportsEachWaypointAndKeepsStationAtTheLast() {
        Client client = driving();

        moveTo(PATH.get(0));
        bench.run(0.1, client);
        moveTo(PATH.get(1));
        bench.run(0.1, client);

        assertThat(client.all(Progress.class))
                .extracting(p -> p.listId() + " " + p.nextIndex() + " " + p.completed())
                .containsExactly(" 0 false", "l1 0 false", "l1 1 false", "l1 2 true");
        assertThat(bench.server.mode()).isEqualTo(BoatMode.HOLD);
    }

    @Test
    void reachesAWaypointAtTheArrivalRadius() {
        Client client = driving();
        LocalFrame goal = new LocalFrame(PATH.get(0).latDeg(), PATH.get(0).lonDeg());

        moveTo(goal.latDeg(0, 3.05), goal.lonDeg(0, 3.05));
        bench.run(0.1, client);
        assertThat(client.all(Progress.class)
                        .get(client.all(Progress.class).size() - 1)
                        .nextIndex())
                .isZero();
        moveTo(goal.latDeg(2.95, 0), goal.lonDeg(2.95, 0));
        bench.run(0.1, client);

        assertThat(client.all(Progress.class)
                        .get(client.all(Progress.class).size() - 1)
                        .nextIndex())
                .isEqualTo(1);
    }

    @Test
    void answersARepeatedIdAndDoesNotExecuteItAgain() {
        Client client = driving();
        assertThat(client.command(new StopMotors("s"))).isInstanceOf(Ack.class);
        client.command(new StartWaypoints("again", "l1", 1));

        for (int i = 0; i < 10; i++) {
            assertThat(client.command(new StopMotors("s"))).isInstanceOf(Ack.class);
            assertThat(client.command(new UploadWaypoints("u", "l1", PATH))).isInstanceOf(Ack.class);
        }

        assertThat(bench.server.mode()).isEqualTo(BoatMode.PATH);
        assertThat(bench.log).containsExactly("u ack", "g ack", "s ack", "again ack");
    }

    @Test
    void answersARepeatedIdAsAtFirstEvenIfItWouldNowSucceed() {
        Client client = bench.commander();
        assertNack(client.command(new StartWaypoints("c", "l1", 0)), NackReason.UNKNOWN_LIST);
        client.command(new UploadWaypoints("u", "l1", PATH));

        assertNack(client.command(new StartWaypoints("c", "l1", 0)), NackReason.UNKNOWN_LIST);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
    }

    @Test
    void refusalOfAnObserverDoesNotSpoilTheIdForTheCommander() {
        Client client = bench.commander();
        Client observer = bench.client(Role.OBSERVER, 1);

        assertNack(observer.command(new HoldPosition("h")), NackReason.NOT_COMMANDER);
        assertThat(client.command(new HoldPosition("h"))).isInstanceOf(Ack.class);
    }

    @Test
    void refusesMotionThatALaterCommandOvertookButNeverAStop() {
        Client client = bench.commander();
        client.say(10, new UploadWaypoints("u", "l1", PATH));
        client.say(12, new HoldPosition("h"));

        assertNack(client.say(11, new StartWaypoints("late", "l1", 0)).get(0), NackReason.STALE);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.HOLD);
        assertThat(client.say(3, new StopMotors("stop")).get(0)).isInstanceOf(Ack.class);
        assertThat(client.say(13, new StartWaypoints("late", "l1", 0)).get(0)).isInstanceOf(Ack.class);
    }

    @Test
    void steersTowardsTheWaypointTheShorterWay() {
        Client client = driving();

        assertThat(bench.vehicle.rudder()).isZero();
        assertThat(bench.vehicle.thrust()).isGreaterThan(0.4);
        bench.vehicle.headingRad = 0.3;
        bench.run(0.1, client);
        assertThat(bench.vehicle.rudder()).isNegative();
        bench.vehicle.headingRad = -3.0;
        bench.run(0.1, client);
        assertThat(bench.vehicle.rudder()).isEqualTo(1);
        assertThat(bench.vehicle.thrust()).isZero();
    }

    @Test
    void boatThatDoesNotKnowWhereItIsRestsAndSaysThatItIsThere() {
        Client client = driving();
        bench.vehicle.eastM = Double.NaN;
        int before = client.all(Telemetry.class).size();
        bench.run(3, client);

        assertThat(bench.vehicle.isResting()).isTrue();
        assertThat(bench.server.mode()).isEqualTo(BoatMode.PATH);
        assertThat(client.all(Telemetry.class)).hasSize(before);
        assertThat(client.all(Heartbeat.class)).hasSizeGreaterThan(1);
        bench.vehicle.eastM = 0;
        bench.run(1, client);
        assertThat(bench.vehicle.thrust()).isBetween(0.4, 1.0);
        assertThat(client.all(Telemetry.class)).hasSizeGreaterThan(before);
    }

    @Test
    void boatWhoseControlFailsRests() {
        Client client = driving();
        bench.vehicle.fails = true;

        assertThatThrownBy(() -> bench.run(0.1, client)).isInstanceOf(IllegalStateException.class);
        assertThat(bench.vehicle.isResting()).isTrue();
        bench.vehicle.fails = false;
        bench.run(0.1, client);
        assertThat(bench.vehicle.thrust()).isPositive();
    }

    @Test
    void takesGainsAndVelocityMultiplier() {
        Client client = driving();
        double cruise = bench.vehicle.thrust();
        bench.vehicle.headingRad = -0.1;
        bench.run(0.1, client);
        double rudder = bench.vehicle.rudder();

        assertThat(client.command(new SetGains("g1", GainAxis.HEADING, 2.4, 0, 0)))
                .isInstanceOf(Ack.class);
        assertThat(client.command(new SetGains("g2", GainAxis.SPEED, 0, 0, 0))).isInstanceOf(Ack.class);
        assertThat(client.command(new SetVelocityMultiplier("v", 0.5))).isInstanceOf(Ack.class);
        bench.run(0.1, client);

        assertThat(bench.vehicle.rudder()).isCloseTo(2 * rudder, within(1e-3));
        assertThat(bench.vehicle.thrust()).isBetween(0.2, 0.3).isLessThan(cruise);
    }

    @Test
    void teleoperationStopsTheMotorsTwoSecondsAfterTheLastSetting() {
        Client client = bench.commander();
        client.say(new Teleoperate(0.6, -0.2));
        bench.run(1.9, client);

        assertThat(bench.server.mode()).isEqualTo(BoatMode.TELEOPERATION);
        assertThat(bench.vehicle.thrust()).isEqualTo(0.6, within(1e-12));
        assertThat(bench.vehicle.rudder()).isEqualTo(-0.2, within(1e-12));
        bench.run(0.1, client);

        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
        assertThat(bench.vehicle.isResting()).isTrue();
    }

    @Test
    void lateSettingByHandIsDropped() {
        Client client = bench.commander();
        client.say(20, new Teleoperate(0, 0));
        client.say(19, new Teleoperate(1, 0));
        bench.run(0.1, client);

        assertThat(bench.vehicle.thrust()).isZero();
    }

    @Test
    void observerDoesNotTeleoperate() {
        bench.commander();
        Client observer = bench.client(Role.OBSERVER, 1);
        observer.say(new Teleoperate(1, 0));

        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
    }

    @Test
    void fleetStopIsLatchedUntilReleased() {
        Client client = driving();
        client.command(new FleetStop("f"));
        bench.run(0.1, client);

        assertThat(bench.vehicle.isResting()).isTrue();
        assertNack(client.command(new StartWaypoints("a", "l1", 0)), NackReason.FLEET_STOPPED);
        assertNack(client.command(new HoldPosition("b")), NackReason.FLEET_STOPPED);
        assertThat(client.command(new StopMotors("c"))).isInstanceOf(Ack.class);
        client.say(new Teleoperate(1, 0));
        bench.run(10);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.FLEET_STOP);

        client.say(new Hello("boat1", "test", Role.COMMANDER, 1, "")); // its link was lost meanwhile
        client.command(new FleetRelease("r"));
        bench.run(1, client);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
        assertThat(bench.vehicle.isResting()).isTrue();
        assertThat(client.command(new StartWaypoints("d", "l1", 0))).isInstanceOf(Ack.class);
    }

    @Test
    void noiseDoesNotKeepTheLinkAlive() {
        Client client = driving();
        for (int i = 0; i < 36; i++) {
            client.session.receive(FrameBytes.of("noise"), bench.nowMs);
            bench.run(0.1);
        }

        assertThat(bench.server.mode()).isEqualTo(BoatMode.HOLD);
        assertThat(client.session.refusedFrames()).isEqualTo(36);
    }

    @Test
    void regainedLinkStartsNothing() {
        Client client = driving();
        bench.run(4);
        client.say(new Hello("boat1", "test", Role.COMMANDER, 1, ""));
        bench.run(5, client);

        assertThat(bench.server.hasCommander()).isTrue();
        assertThat(bench.server.mode()).isEqualTo(BoatMode.HOLD);
        assertThat(client.command(new StartWaypoints("on", "l1", 1))).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.PATH);
    }

    @Test
    void whatComesThirtySecondsLateMovesNothingButStillStops() {
        Client client = driving();
        bench.run(30);

        assertNack(client.command(new StartWaypoints("late", "l1", 1)), NackReason.NOT_GREETED);
        client.say(new Teleoperate(1, 0));
        assertNack(client.command(new UploadWaypoints("u", "late", PATH)), NackReason.NOT_GREETED);
        bench.run(1, client);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.HOLD);
        assertThat(bench.server.hasCommander()).isFalse();
        assertThat(client.command(new StopMotors("stop"))).isInstanceOf(Ack.class);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);

        client.say(new Hello("boat1", "test", Role.COMMANDER, 1, ""));
        assertThat(client.command(new StartWaypoints("on", "l1", 1))).isInstanceOf(Ack.class);
    }

    @Test
    void boatThatNobodyEverCommandedIsNotLost() {
        Client observer = bench.client(Role.OBSERVER, 1);
        bench.run(20);

        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
        assertThat(observer.all(Telemetry.class)).hasSize(20);
    }

    @Test
    void boatOnStationDrivesBackOnlyWhenItHasDriftedOutOfItsRadius() {
        Client client = bench.commander();
        client.command(new HoldPosition("h"));
        bench.vehicle.northM = -4.9;
        bench.run(0.1, client);
        assertThat(bench.vehicle.isResting()).isTrue();

        bench.vehicle.northM = -5.1;
        bench.run(0.1, client);
        assertThat(bench.vehicle.thrust()).isPositive();
        bench.vehicle.northM = -3;
        bench.run(0.1, client);
        assertThat(bench.vehicle.thrust()).isPositive();
        bench.vehicle.northM = -2.4;
        bench.run(0.1, client);
        assertThat(bench.vehicle.isResting()).isTrue();
    }

    @Test
    void telemetryComesAtTheRateThatTheClientWishes() {
        Client fast = bench.client(Role.COMMANDER, 10);
        Client usual = bench.client(Role.OBSERVER, 0);
        Client slow = bench.client(Role.OBSERVER, 0.2);
        bench.run(10, fast);

        assertThat(fast.all(Telemetry.class)).hasSize(100);
        assertThat(usual.all(Telemetry.class)).hasSize(10);
        assertThat(slow.all(Telemetry.class))
                .as("at once, then at times of the boat's own")
                .hasSizeBetween(2, 3);
        assertThat(slow.all(Heartbeat.class)).as("once a second at least").hasSizeBetween(9, 11);
    }

    @Test
    void boatsThatAreGreetedInOneMomentSpreadTheirTelemetryOverTheSecond() {
        Set<Long> times = new TreeSet<>();
        for (String boat : List.of("anna", "boat1", "boat2", "boat3", "dora", "emil")) {
            ServerTestBench other = new ServerTestBench(boat);
            Client client = other.commander();
            other.run(4, client);
            List<Telemetry> all = client.all(Telemetry.class);
            List<Long> later = all.subList(1, all.size()).stream()
                    .map(telemetry -> telemetry.boatTimeMs() % 1000)
                    .distinct()
                    .collect(Collectors.toList());

            assertThat(all.get(1).boatTimeMs() - all.get(0).boatTimeMs()).isBetween(1L, 1000L);
            assertThat(later).as("always at the same moment of a second").hasSize(1);
            times.addAll(later);
        }

        assertThat(times).hasSizeGreaterThan(3);
    }

    @Test
    void batteryIsReportedAtSubscriptionAndAtEachChangeOfClass() {
        Client client = bench.commander();
        for (double percent : new double[] {50, 30, 29.9, 20, 15, 14.9, 0, 100}) {
            bench.vehicle.batteryPercent = percent;
            bench.run(1, client);
        }

        assertThat(client.all(BatteryReport.class))
                .extracting(BatteryReport::level)
                .containsExactly(BatteryLevel.NOMINAL, BatteryLevel.LOW, BatteryLevel.CRITICAL, BatteryLevel.NOMINAL);
    }

    @Test
    void ledgerOfAnswersDoesNotGrowWithoutEnd() {
        Client client = bench.commander();
        for (int i = 0; i < 5000; i++) {
            client.command(new StopMotors("s" + i));
        }

        client.command(new StopMotors("s4999"));
        client.command(new StopMotors("s0"));
        assertThat(bench.log).hasSize(5001);
    }

    private Client driving() {
        Client client = bench.commander();
        client.command(new UploadWaypoints("u", "l1", PATH));
        client.command(new StartWaypoints("g", "l1", 0));
        bench.run(0.1, client);
        return client;
    }

    private void moveTo(Waypoint waypoint) {
        moveTo(waypoint.latDeg(), waypoint.lonDeg());
    }

    private void moveTo(double latDeg, double lonDeg) {
        LocalFrame frame = new LocalFrame(45, 10);
        bench.vehicle.eastM = frame.eastM(latDeg, lonDeg);
        bench.vehicle.northM = frame.northM(latDeg, lonDeg);
    }

    private static void assertNack(LinkMessage answer, NackReason reason) {
        assertThat(answer)
                .isInstanceOfSatisfying(
                        Nack.class, nack -> assertThat(nack.reason()).isEqualTo(reason));
    }
}
