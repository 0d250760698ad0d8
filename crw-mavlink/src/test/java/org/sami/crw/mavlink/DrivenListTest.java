package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;

/** How far a vehicle is along a list of which it holds a part, by what it reports. */
class DrivenListTest {
    private static final List<Waypoint> WAYPOINTS = IntStream.range(0, 1_000)
            .mapToObj(i -> new Waypoint(45.7 + i * 1e-4, 10.72, 1))
            .toList();
    private static final int LAST = 1_001; // the last waypoint's item: home and the speed come first

    private final DrivenList list = new DrivenList(new UploadWaypoints("upload", "long", WAYPOINTS));
    private MissionWindow lastPart;

    /** The vehicle holds all but the last part, and is near its stop. */
    @BeforeEach
    void drive() {
        list.advance(700);
        lastPart = list.nextWindow().orElseThrow();
        while (lastPart.to() <= LAST) {
            list.window(lastPart.stoppingAtItsEnd());
            lastPart = list.nextWindow().orElseThrow();
        }
        list.window(lastPart);
    }

    @Test
    void waypointBehindTheGateIsNotReachedWhileThePartIsWritten() {
        assertThat(list.reached(lastPart.slot(LAST))).isFalse();
        assertThat(list.current(lastPart.slot(LAST) + 1)).isFalse();
        assertThat(list.next()).isEqualTo(700);
    }

    @Test
    void endIsReachedByAVehicleThatIsThereBeforeTheLastPartWasReadBack() {
        list.replacesStop();

        assertThat(list.reached(lastPart.slot(LAST))).isTrue();
        assertThat(list.isCompleted()).isTrue();
    }

    @Test
    void itemToWhichItGoesCountsBeforeTheLastPartWasReadBack() {
        list.replacesStop();

        assertThat(list.current(lastPart.slot(LAST))).isTrue();
        assertThat(list.next()).isEqualTo(WAYPOINTS.size() - 1);
    }

    @Test
    void partThatIsSentAgainStaysOpenedAndAnotherDoesNot() {
        list.replacesStop();
        list.window(lastPart);
        assertThat(list.current(lastPart.slot(LAST))).isTrue();

        list.window(list.windowFrom(0));
        assertThat(list.reached(lastPart.slot(LAST))).isFalse();
    }

    @Test
    void waypointsThatItIsKnownToHavePassedAreNotLookedForAgainWhereProgressCountsFromAnEarlierOne() {
        int item = list.itemOf(703);
        list.countFrom(650);

        assertThat(list.passedBy(item)).isEqualTo(WAYPOINTS.subList(700, 703));
        assertThat(list.passed()).isEqualTo(700);
        assertThat(list.next()).isEqualTo(650);
    }

    @Test
    void waypointsOfAListThatBeginsAnewAreLookedForAgain() {
        int item = list.itemOf(703);
        list.startAt(650);

        assertThat(list.passedBy(item)).isEqualTo(WAYPOINTS.subList(650, 703));
    }
}
