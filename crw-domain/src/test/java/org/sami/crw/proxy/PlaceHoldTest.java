package org.sami.crw.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Progress;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.SafetyMargin;
import org.sami.crw.service.water.Water;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** A boat whose path was given up holds its place until somebody decides (docs/services.md). */
class PlaceHoldTest {
    private static final GeoPoint HERE = GeoPoint.of(45, 10);
    private static final List<GeoPoint> POINTS = List.of(GeoPoint.of(45.01, 10.01), GeoPoint.of(45.02, 10.01));
    private static final int UNTIL_GIVEN_UP_S = 302;

    private final List<String> heard = new ArrayList<>();
    private final ScriptedBoat boat = new ScriptedBoat(event -> {
        if (event instanceof FleetEvent.CommandFailed failed) {
            heard.add("failed " + failed.command().commandId());
        } else if (event instanceof FleetEvent.PlaceHeld held) {
            heard.add("holds after " + held.givenUp().commandId());
        }
    });

    @BeforeEach
    void link() {
        boat.linked("b1");
    }

    private static FollowPath path(String id, long mission) {
        return FollowPath.of(id, mission, mission * 10, POINTS, Priority.LOW);
    }

    private void giveUp(FollowPath path) {
        boat.proxy.commands().submit(path);
        boat.setsOut();
        boat.onPathAt(HERE, 80, UNTIL_GIVEN_UP_S);
        assertThat(heard).startsWith("failed " + path.commandId());
    }

    private void holds() {
        boat.setsOut();
        boat.says(new Progress(boat.last(UploadWaypoints.class).listId(), 1, true));
    }

    private long stops() {
        return boat.said.stream()
                .filter(StopMotors.class::isInstance)
                .map(message -> ((StopMotors) message).commandId())
                .distinct()
                .count();
    }

    private long uploads() {
        return boat.said.stream().filter(UploadWaypoints.class::isInstance).count();
    }

    private void liesFor(double seconds) {
        for (int i = 0; i < seconds; i++) {
            boat.silent(1);
            boat.says(new Telemetry(HERE.latDeg(), HERE.lonDeg(), 0, 0, 80, BoatMode.STOPPED, i));
        }
    }

    @Test
    void theBoatIsSentToWhereItIsAndNotStopped() {
        giveUp(path("c", 1));

        assertThat(boat.last(UploadWaypoints.class).waypoints())
                .singleElement()
                .extracting(Waypoint::latDeg, Waypoint::lonDeg)
                .containsExactly(45.0, 10.0);
        holds();

        assertThat(heard).containsExactly("failed c", "holds after c");
        assertThat(stops()).isZero();
        assertThat(boat.proxy.isAtRest()).as("no mission wants it").isTrue();
        assertThat(boat.proxy.explain().cause()).isEqualTo(Cause.KEEPS_STATION);
        assertThat(boat.proxy.explain().text())
                .startsWith(
                        "boat1 holds its place until it gets a command or is stopped: following its path for mission 1"
                                + " failed: it has come no nearer to point 1");
    }

    @Test
    void inWhatItIsNotToEnterItIsSentOutOfIt() {
        GeoArea area = new GeoArea(
                List.of(
                        GeoPoint.of(44.9999, 9.9990),
                        GeoPoint.of(44.9999, 10.0010),
                        GeoPoint.of(45.0010, 10.0010),
                        GeoPoint.of(45.0010, 9.9990)),
                List.of());
        Water water = Water.of(HERE, List.of(area), Optional.empty()).drivenWith(CrossTrackError.FIELD);

        boat.onPathAt(HERE, 80, 1);
        giveUp(path("c", 1).in(water));

        List<Waypoint> way = boat.last(UploadWaypoints.class).waypoints();
        Waypoint place = way.get(way.size() - 1);
        GeoPoint to = GeoPoint.of(place.latDeg(), place.lonDeg());
        double marginM = new SafetyMargin(CrossTrackError.FIELD).pathM();
        assertThat(water.clearanceM(to)).isBetween(marginM - 0.1, marginM + 0.1);
        assertThat(Geodesy.distanceM(HERE, to)).as("the short way").isLessThan(12 + marginM);
    }

    @Test
    void theNextCommandOfWhateverMissionTakesTheBoatAndTheHoldDoesNotComeBack() {
        giveUp(path("c", 1));
        holds();

        boat.proxy.commands().submit(path("d", 2));
        boat.setsOut();
        long sent = uploads();
        boat.says(new Progress(boat.last(UploadWaypoints.class).listId(), 2, true));
        liesFor(30);

        assertThat(uploads()).isEqualTo(sent);
        assertThat(boat.proxy.explain().cause()).isEqualTo(Cause.ARRIVED);
    }

    @Test
    void whatItsMissionTakesBackOrTheOperatorStopsRestsWithItsMotorsOff() {
        giveUp(path("c", 1));
        holds();

        boat.proxy.commands().withdraw(2);
        assertThat(stops()).as("another mission").isZero();
        boat.proxy.commands().withdraw(1);
        assertThat(stops()).isEqualTo(1);
        boat.says(new Ack(boat.last(StopMotors.class).commandId()));

        heard.clear();
        giveUp(path("d", 3));
        holds();
        boat.proxy.abort("the operator stopped it");
        assertThat(stops()).isEqualTo(2);
        assertThat(boat.proxy.explain().cause()).isEqualTo(Cause.STOPPING);
    }

    @Test
    void whoDrivesItByHandAndAFleetStopEndIt() {
        giveUp(path("c", 1));
        holds();
        boat.proxy.teleoperate(1, 0);
        boat.proxy.release();
        long sent = uploads();
        boat.says(new Ack(boat.last(StopMotors.class).commandId()));
        liesFor(10);
        assertThat(uploads()).isEqualTo(sent);
        assertThat(boat.proxy.explain().cause()).isEqualTo(Cause.FAILED);

        heard.clear();
        giveUp(path("d", 1));
        holds();
        boat.proxy.fleetStop();
        boat.proxy.fleetRelease();
        sent = uploads();
        liesFor(10);
        assertThat(uploads()).isEqualTo(sent);
    }

    @Test
    void aBoatThatWasOutOfReachIsLeftWithWhatItDidByItself() {
        giveUp(path("c", 1));
        holds();
        long sent = uploads();

        boat.silent(60);
        boat.linked("b1");
        liesFor(10);

        assertThat(uploads()).isEqualTo(sent);
        assertThat(stops()).isZero();
        assertThat(boat.proxy.explain().cause()).isEqualTo(Cause.FAILED);
    }

    @Test
    void aPlaceThatCannotBeHeldIsGivenUpOnceAndTheBoatIsStopped() {
        giveUp(path("c", 1));
        boat.setsOut();

        boat.onPathAt(GeoPoint.of(45.001, 10), 80, UNTIL_GIVEN_UP_S);

        assertThat(stops()).isEqualTo(1);
        assertThat(heard).as("no mission asked for it").containsExactly("failed c", "holds after c");
    }
}
