package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.SetWaysHome;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.ServerTestBench.Client;
import org.sami.boat.server.vehicle.LocalFrame;

/** Which of the ways home that its base has sent are in force on a boat: seen by the charge that they take. */
class WaysHomeTest {
    private static final LocalFrame FRAME = new LocalFrame(45, 10);
    private static final List<Waypoint> PATH = List.of(at(0, 400), at(200, 400));

    /** 1 % takes the boat 10 m: 400 m north of home the straight way needs 56 %, one of 800 m more than it has. */
    private final ServerTestBench bench = new ServerTestBench(config -> config.performance(
            new BoatPerformance(OptionalDouble.of(10), OptionalDouble.empty(), OptionalDouble.empty())));

    private static Waypoint at(double eastM, double northM) {
        return new Waypoint(FRAME.latDeg(eastM, northM), FRAME.lonDeg(eastM, northM), 1);
    }

    private static List<List<Waypoint>> about(double eastM) {
        return List.of(List.of(at(eastM, 200)));
    }

    private Client boatOnItsWay() {
        bench.vehicle.batteryPercent = 80;
        Client client = bench.commander();
        client.command(new UploadWaypoints("u", "l1", PATH));
        return client;
    }

    private BatteryLevel level(Client client) {
        bench.run(1.5, client);
        List<BatteryReport> reports = client.all(BatteryReport.class);
        return reports.get(reports.size() - 1).level();
    }

    private void driveTo(double northM) {
        bench.vehicle.northM = northM;
    }

    @Test
    void batteryIsCriticalForTheWayAroundAndNotOnlyForTheStraightOne() {
        Client straight = boatOnItsWay();
        straight.command(new StartWaypoints("s", "l1", 0));
        driveTo(395);
        assertThat(level(straight)).isEqualTo(BatteryLevel.NOMINAL);

        assertThat(straight.command(new SetWaysHome("w", "l1", List.of(about(300), about(300)))))
                .isInstanceOf(Ack.class);
        assertThat(level(straight)).isEqualTo(BatteryLevel.CRITICAL);
    }

    @Test
    void shortestOfSeveralWaysCounts() {
        Client client = boatOnItsWay();
        List<List<Waypoint>> both = List.of(about(300).get(0), about(10).get(0));
        client.command(new SetWaysHome("w", "l1", List.of(both, both)));
        client.command(new StartWaypoints("s", "l1", 0));
        driveTo(395);

        assertThat(level(client)).isEqualTo(BatteryLevel.NOMINAL);
    }

    @Test
    void everyLegHasItsOwnWays() {
        Client client = boatOnItsWay();
        client.command(new SetWaysHome("w", "l1", List.of(List.of(), about(300))));
        client.command(new StartWaypoints("s", "l1", 0));
        driveTo(395);
        assertThat(level(client)).isEqualTo(BatteryLevel.NOMINAL);

        driveTo(400); // the first waypoint
        assertThat(level(client)).isEqualTo(BatteryLevel.CRITICAL);
    }

    @Test
    void startOfAnotherListEndsThem() {
        Client client = boatOnItsWay();
        client.command(new SetWaysHome("w", "l1", List.of(about(300), about(300))));
        client.command(new StartWaypoints("s", "l1", 0));
        client.command(new UploadWaypoints("u2", "l2", PATH));
        client.command(new StartWaypoints("s2", "l2", 0));
        driveTo(395);

        assertThat(level(client)).isEqualTo(BatteryLevel.NOMINAL);
    }

    @Test
    void waysFromAListThatTheBoatDoesNotHoldAreRefused() {
        Client client = boatOnItsWay();

        LinkMessage answer = client.command(new SetWaysHome("w", "l9", List.of(about(300), about(300))));

        assertThat(((Nack) answer).reason()).isEqualTo(NackReason.UNKNOWN_LIST);
    }

    @Test
    void boatThatStartsAnewHasThemBack() {
        Client client = boatOnItsWay();
        client.command(new SetWaysHome("w", "l1", List.of(about(300), about(300))));
        ServerTestBench anew = bench.startedAnew();
        Client again = anew.commander();
        anew.vehicle.batteryPercent = 80;
        anew.vehicle.northM = 395;
        again.command(new StartWaypoints("s", "l1", 0));
        anew.run(1.5, again);

        List<BatteryReport> reports = again.all(BatteryReport.class);
        assertThat(reports.get(reports.size() - 1).level()).isEqualTo(BatteryLevel.CRITICAL);
    }
}
