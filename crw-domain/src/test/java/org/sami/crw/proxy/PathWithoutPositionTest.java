package org.sami.crw.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.Water;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** A boat that may not go everywhere, and has not said yet where it is: no way for it can be planned. */
class PathWithoutPositionTest {
    private static final GeoPoint HERE = GeoPoint.of(45, 10);
    private static final GeoPoint BEHIND_THE_ROCK = Geodesy.offset(HERE, 0, 100);
    private static final GeoArea ROCK = new GeoArea(
            List.of(
                    Geodesy.offset(HERE, -10, 40),
                    Geodesy.offset(HERE, 10, 40),
                    Geodesy.offset(HERE, 10, 60),
                    Geodesy.offset(HERE, -10, 60)),
            List.of());
    private static final Water WATER = Water.of(HERE, List.of(ROCK), Optional.empty());

    private final ScriptedBoat boat = new ScriptedBoat(event -> {});

    @BeforeEach
    void link() {
        boat.linked("b1");
    }

    private static BoatCommand path() {
        return FollowPath.of("c", 1, 1, List.of(BEHIND_THE_ROCK), Priority.MEDIUM)
                .in(WATER);
    }

    private void saysWhereItIs() {
        boat.says(new Telemetry(HERE.latDeg(), HERE.lonDeg(), 0, 0, 90, BoatMode.STOPPED, 1));
    }

    private void assertSentAroundTheRock() {
        List<GeoPoint> points = boat.last(UploadWaypoints.class).waypoints().stream()
                .map(waypoint -> GeoPoint.of(waypoint.latDeg(), waypoint.lonDeg()))
                .toList();
        assertThat(points).hasSizeGreaterThan(1);
        assertThat(WATER.clearanceM(List.of(HERE, points.get(0)))).isPositive();
        assertThat(WATER.clearanceM(points)).isPositive();
    }

    @Test
    void getsItsPathOnceItHasSaidWhereItIsAndThenAroundTheRock() {
        boat.proxy.commands().submit(path());
        boat.alive(3);
        assertThat(boat.said).noneMatch(UploadWaypoints.class::isInstance);

        saysWhereItIs();

        assertSentAroundTheRock();
    }

    @Test
    void isSentToItsStationOnceItHasSaidWhereItIs() {
        boat.proxy.commands().submit(new KeepStation("k", 1, 1, BEHIND_THE_ROCK, 10, Priority.MEDIUM, false).in(WATER));
        assertThat(boat.said).noneMatch(UploadWaypoints.class::isInstance);

        saysWhereItIs();

        assertSentAroundTheRock();
    }

    @Test
    void waitingIsExplained() {
        boat.proxy.commands().submit(path());

        assertThat(boat.proxy.explain().cause()).isEqualTo(Cause.NO_POSITION);
        assertThat(boat.proxy.explain().text())
                .isEqualTo("boat1 does not move: it has not said where it is, so its way cannot be checked; one command"
                        + " waits");
    }

    @Test
    void boatThatDoesSomethingElseIsStoppedMeanwhile() {
        boat.proxy.commands().submit(FollowPath.of("open", 2, 1, List.of(BEHIND_THE_ROCK), Priority.LOW));
        boat.setsOut();

        boat.proxy.commands().submit(path());

        assertThat(boat.said).anyMatch(StopMotors.class::isInstance);
        saysWhereItIs();
        assertSentAroundTheRock();
    }

    @Test
    void boatThatMayGoEverywhereGetsItsPathAtOnce() {
        boat.proxy.commands().submit(FollowPath.of("open", 2, 1, List.of(BEHIND_THE_ROCK), Priority.LOW));

        assertThat(boat.said).anyMatch(UploadWaypoints.class::isInstance);
    }
}
