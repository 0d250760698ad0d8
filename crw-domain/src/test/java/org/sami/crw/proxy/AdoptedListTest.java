package org.sami.crw.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.Welcome;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.command.UploadCount;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** A base that died and goes on finds the list in the boat that it sent when it lived. */
class AdoptedListTest {
    private static final List<GeoPoint> POINTS =
            List.of(GeoPoint.of(45, 10), GeoPoint.of(45.001, 10), GeoPoint.of(45.002, 10));
    private static final String LIST = "c#earlier.0.3";

    private final List<String> heard = new ArrayList<>();
    private final ScriptedBoat boat = new ScriptedBoat(event -> {
        if (event instanceof FleetEvent.Progressed progressed) {
            heard.add("progress " + progressed.visited());
        } else if (event instanceof FleetEvent.CommandCompleted) {
            heard.add("completed");
        }
    });

    @Test
    void theBoatGoesOnWithItWithoutAnUploadBehindWhatItHasVisitedMeanwhile() {
        comesBack(LIST, new Progress(LIST, 2, false));
        holds(LIST, 1.5);

        assertThat(said(UploadWaypoints.class)).isZero();
        StartWaypoints start = boat.last(StartWaypoints.class);
        assertThat(start.listId()).isEqualTo(LIST);
        assertThat(start.index()).isEqualTo(2);
        assertThat(start.commandId())
                .as("the earlier process has used up its own")
                .doesNotStartWith(LIST);
        boat.acknowledges(StartWaypoints.class);
        assertThat(boat.proxy.explain().shouldMove()).isTrue();
        assertThat(boat.proxy.commands().upload()).hasValueSatisfying(upload -> {
            assertThat(upload.state()).isEqualTo(Upload.State.TAKEN_OVER);
            assertThat(upload.way()).isEqualTo(POINTS);
        });
        assertThat(boat.proxy.commands().uploads()).isEqualTo(UploadCount.NONE);
        boat.says(new Progress(LIST, 3, true));
        assertThat(heard).containsExactly("progress 2", "progress 3", "completed");
    }

    @Test
    void itIsReadBackAgainWhereTheLinkIsLostBeforeTheAnswer() {
        comesBack(LIST, new Progress(LIST, 1, false));
        String unanswered = boat.last(ReadBack.class).commandId();

        boat.silent(5);
        boat.says(new Welcome("boat1", "b1", Role.COMMANDER, ""));
        boat.says(new Progress(LIST, 2, false));
        assertThat(boat.last(ReadBack.class).commandId()).isNotEqualTo(unanswered);
        holds(LIST, 1.5);

        assertThat(said(UploadWaypoints.class)).isZero();
        assertThat(boat.last(StartWaypoints.class).listId()).isEqualTo(LIST);
        assertThat(boat.last(StartWaypoints.class).index()).isEqualTo(2);
    }

    @Test
    void whatTheBoatHasFinishedMeanwhileIsComplete() {
        comesBack(LIST, new Progress(LIST, 3, true));
        holds(LIST, 1.5);

        assertThat(heard).containsExactly("progress 3", "completed");
        assertThat(said(StartWaypoints.class)).isZero();
    }

    @Test
    void aListWithOtherPointsOrSpeedsIsNotThePath() {
        comesBack(LIST, new Progress(LIST, 2, false));
        holds(LIST, 0.7);

        assertThat(said(UploadWaypoints.class)).isEqualTo(1);
        boat.setsOut();
        assertThat(boat.last(StartWaypoints.class).index()).isZero();
        assertThat(heard).isEmpty();
    }

    /** Another session's mission may have had a command of the same name, for the same points. */
    @Test
    void aListThatThisSessionDidNotSendIsNotThePath() {
        comesBack("c#earlier.0.2", new Progress("c#another.0.1", 3, true));

        assertThat(said(ReadBack.class)).isZero();
        assertThat(boat.last(UploadWaypoints.class).listId()).startsWith("c#base.");
    }

    @Test
    void theListOfAnotherCommandIsNotThePath() {
        comesBack("b#earlier.0.1", new Progress("b#earlier.0.1", 3, true));

        assertThat(said(UploadWaypoints.class)).isEqualTo(1);
    }

    @Test
    void itIsAskedAboutOnceOnly() {
        comesBack(LIST, new Progress(LIST, 2, false));
        holds(LIST, 1.5);
        boat.proxy.commands().submit(FollowPath.goTo("now", 2, 2, POINTS.get(0), Priority.CRITICAL));
        boat.setsOut();
        boat.says(new Progress(boat.last(UploadWaypoints.class).listId(), 1, true));

        assertThat(boat.last(UploadWaypoints.class).listId()).startsWith("c#base.");
        boat.setsOut();
        assertThat(boat.last(StartWaypoints.class).index()).isEqualTo(2);
    }

    private void comesBack(String known, Progress held) {
        boat.says(new Welcome("boat1", "b1", Role.COMMANDER, ""));
        boat.proxy.commands().knownList(known);
        boat.proxy.commands().submit(FollowPath.of("c", 1, 1, POINTS, Priority.MEDIUM));
        boat.says(held);
    }

    private void holds(String listId, double speedMps) {
        List<Waypoint> waypoints = POINTS.stream()
                .map(point -> new Waypoint(point.latDeg(), point.lonDeg(), speedMps))
                .toList();
        boat.says(new HeldWaypoints(boat.last(ReadBack.class).commandId(), listId, waypoints));
    }

    private long said(Class<? extends LinkMessage> kind) {
        return boat.said.stream().filter(kind::isInstance).count();
    }
}
