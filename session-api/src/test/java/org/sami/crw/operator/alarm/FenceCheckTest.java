package org.sami.crw.operator.alarm;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.queue.TurnWait;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** What a boat did between two positions in what its mission avoids, however narrow that is. */
class FenceCheckTest {
    private static final GeoPoint ORIGIN = GeoPoint.of(45.4, 10.9);
    private static final String THROUGH = "boat1 went through an area that mission 1 is to keep out of";

    private final FenceCheck fence = new FenceCheck(MissionTitles.NONE);
    private final CommandQueueSnapshot sent = new CommandQueueSnapshot(
            Optional.of(new CommandQueueSnapshot.Entry(
                    FollowPath.goTo("go", 1, 1, at(50, 0), Priority.MEDIUM), 0, 1, TurnWait.NOT)),
            List.of(),
            OptionalLong.empty());

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(ORIGIN, eastM, northM);
    }

    private static GeoArea box(double west, double south, double east, double north) {
        return new GeoArea(List.of(at(west, south), at(east, south), at(east, north), at(west, north)), List.of());
    }

    private Optional<String> after(GeoPoint before, GeoPoint now) {
        fence.position("boat1", before, sent);
        return fence.position("boat1", now, sent);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 1, 2, 3.9, 4.1, 20})
    void boatThatWentThroughIsToldHoweverNarrowTheAreaIs(double wideM) {
        fence.setAvoided(Map.of(1L, List.of(box(0, -100, wideM, 100))));

        assertThat(after(at(-5, 0), at(wideM + 5, 2))).contains(THROUGH);
    }

    @Test
    void narrowPierOfAWideAreaCountsToo() {
        GeoArea pier = new GeoArea(
                List.of(at(0, 0), at(2, 0), at(2, 60), at(40, 60), at(40, 100), at(-40, 100), at(-40, 60), at(0, 60)),
                List.of());
        fence.setAvoided(Map.of(1L, List.of(pier)));

        assertThat(after(at(-5, 20), at(7, 20))).contains(THROUGH);
    }

    @Test
    void boatThatPassesBesideIsNoConcern() {
        fence.setAvoided(Map.of(1L, List.of(box(0, -100, 2, 100), box(10, -100, 40, 100))));

        assertThat(after(at(-0.6, -90), at(-0.6, 90))).isEmpty();
        assertThat(after(at(0.05, 90), at(0.05, -90))).isEmpty(); // as its position wanders
        assertThat(after(at(11.5, -90), at(11.5, 90))).isEmpty(); // likewise
    }
}
