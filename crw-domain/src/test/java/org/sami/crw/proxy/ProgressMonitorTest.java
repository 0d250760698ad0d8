package org.sami.crw.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Progress;
import org.sami.boat.link.UploadWaypoints;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** A boat that does not get on along its path: aground, in weeds, against the wind. */
class ProgressMonitorTest {
    private static final GeoPoint START = GeoPoint.of(45, 10);

    private final List<String> failed = new ArrayList<>();
    private final ScriptedBoat boat = new ScriptedBoat(event -> {
        if (event instanceof FleetEvent.CommandFailed news) {
            failed.add(news.command().commandId() + ": " + news.reason());
        }
    });

    @BeforeEach
    void setOut() {
        boat.linked("b1");
        List<GeoPoint> points = List.of(north(100), north(110), north(500));
        boat.proxy.commands().submit(FollowPath.of("c", 1, 1, points, Priority.MEDIUM));
        boat.setsOut();
    }

    @Test
    void aBoatThatComesNoNearerForFiveMinutesFailsItsPathAndHoldsItsPlace() {
        boat.onPathAt(north(40), 80, 299);
        assertThat(failed).isEmpty();

        boat.onPathAt(north(40), 80, 5);

        assertThat(failed).containsExactly("c: it has come no nearer to point 1 for 300 s");
        assertThat(boat.last(UploadWaypoints.class).waypoints()).hasSize(1);
    }

    @Test
    void aBoatThatDriftsToAndFroGetsNowhere() {
        for (int i = 0; i < 200; i++) {
            boat.onPathAt(north(40 + i % 2), 80, 2);
        }

        assertThat(failed).hasSize(1);
    }

    @Test
    void aSlowBoatIsNoStuckBoat() {
        for (int i = 0; i < 90; i++) {
            boat.onPathAt(north(i / 2.0), 80, 10); // 5 cm a second
        }

        assertThat(failed).isEmpty();
        assertThat(boat.proxy.explain().shouldMove()).isTrue();
    }

    @Test
    void aPointThatIsReachedCountsAsGettingOn() {
        boat.onPathAt(north(99), 80, 200);
        boat.says(new Progress(boat.last(UploadWaypoints.class).listId(), 1, false));
        boat.onPathAt(north(99), 80, 200);
        boat.says(new Progress(boat.last(UploadWaypoints.class).listId(), 2, false));
        boat.onPathAt(north(99), 80, 200);

        assertThat(failed).isEmpty();
    }

    @Test
    void anEmptyBatteryIsNoReasonToGiveThePathUp() {
        boat.onPathAt(north(40), 0, 1000);
        boat.onPathAt(north(40), 80, 100);

        assertThat(failed).isEmpty();
    }

    @Test
    void aLostLinkIsNoReasonToGiveThePathUp() {
        boat.onPathAt(north(40), 80, 200);
        boat.silent(600);
        boat.linked("b1");
        boat.setsOut();
        boat.onPathAt(north(40), 80, 200);

        assertThat(failed).isEmpty();
    }

    private static GeoPoint north(double metres) {
        return Geodesy.offset(START, 0, metres);
    }
}
