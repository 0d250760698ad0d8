package org.sami.crw.operator.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.boat.BoatCommands;
import org.sami.crw.operator.mission.MissionEnd.BoatChange;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.queue.CommandQueueSnapshot.Entry;
import org.sami.crw.proxy.queue.TurnWait;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

class MissionEndTest {
    private static final MissionsSnapshot MISSIONS = new MissionsSnapshot(
            List.of(mission(1, Ids.NONE), mission(2, 1), mission(3, Ids.NONE), mission(4, 2)), Map.of(), 0);

    @Test
    void aBoatOfASubMissionGoesOnWithWhatAnotherMissionWants() {
        Entry lost = entry(4, Priority.MEDIUM);
        Entry also = entry(2, Priority.MEDIUM);
        Entry next = entry(3, Priority.MEDIUM);

        MissionEnd end = end(boat(Optional.of(lost), List.of(also, next), OptionalLong.of(4)));

        assertThat(end.subMissions()).extracting(MissionSnapshot::id).containsExactly(2L, 4L);
        assertThat(end.boats()).containsExactly(new BoatChange("anna", Optional.of(lost), 1, Optional.of(next)));
    }

    @Test
    void aBoatThatNobodyElseWantsStops() {
        Entry lost = entry(1, Priority.MEDIUM);

        assertThat(end(boat(Optional.of(lost), List.of(), OptionalLong.empty())).boats())
                .containsExactly(new BoatChange("anna", Optional.of(lost), 0, Optional.empty()));
    }

    @Test
    void aBoatKeepsWhatAnotherMissionHasItDo() {
        Entry runs = entry(3, Priority.HIGH);
        Entry waits = entry(1, Priority.MEDIUM);

        assertThat(end(boat(Optional.of(runs), List.of(waits), OptionalLong.empty()))
                        .boats())
                .containsExactly(new BoatChange("anna", Optional.empty(), 1, Optional.of(runs)));
        assertThat(end(boat(Optional.of(runs), List.of(), OptionalLong.empty())).boats())
                .as("nothing of it ends")
                .isEmpty();
    }

    @Test
    void aBlockOfAnotherMissionKeepsThirdsFromTheirTurn() {
        Entry lost = entry(1, Priority.CRITICAL);
        Entry barred = entry(5, Priority.MEDIUM);

        assertThat(end(boat(Optional.of(lost), List.of(barred), OptionalLong.of(3)))
                        .boats())
                .containsExactly(new BoatChange("anna", Optional.of(lost), 0, Optional.empty()));
    }

    private static MissionEnd end(BoatCommands boat) {
        return MissionEnd.of(1, MISSIONS, List.of(boat), List.of());
    }

    private static BoatCommands boat(Optional<Entry> current, List<Entry> waiting, OptionalLong blockedBy) {
        return new BoatCommands(
                "anna", new CommandQueueSnapshot(current, waiting, blockedBy), Optional.empty(), "", List.of());
    }

    private static Entry entry(long mission, Priority priority) {
        return new Entry(
                FollowPath.goTo("c" + mission, mission, mission, GeoPoint.of(45, 10), priority), 0, 1, TurnWait.NOT);
    }

    private static MissionSnapshot mission(long id, long parent) {
        return new MissionSnapshot(
                id,
                parent,
                "",
                "plan",
                "Plan " + id,
                "",
                0,
                Optional.empty(),
                OptionalLong.empty(),
                Map.of(),
                Set.of(),
                0,
                List.of(),
                Map.of(),
                MissionSnapshot.Details.NONE,
                Optional.empty());
    }
}
