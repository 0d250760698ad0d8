package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.Waypoint;
import org.sami.mavlink.mission.MissionItem;

/** Which items a boat cannot carry out. */
class MissionPathTest {
    @ParameterizedTest
    @CsvSource({
        "0, 16, 0, 0, true", // a waypoint there is the home, which is no place to go to
        "1, 16, 0, 0, false",
        "0, 17, 0, 0, false",
        "0, 19, 0, 0, false",
        "2, 17, 0, 0, false",
        "0, 17, 45, 10, true",
        "0, 19, 0, 10, true"
    })
    void noItemSendsABoatToZeroZero(int number, int command, double lat, double lon, boolean taken) {
        MissionItem item = new MissionItem(number, command, 3, lat, lon, 0, 0, 0, 0, 0);

        assertThat(MissionPath.whyNot(item).isEmpty()).isEqualTo(taken);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 2, 3, 5, 6, 10, 11})
    void aBoatKnowsAllFramesWithLatitudeAndLongitude(int frame) {
        assertThat(MissionPath.isKnownFrame(waypoint(frame))).isTrue();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 4, 7, 8, 9, 12, 20, 21})
    void aBoatKnowsNoFrameThatCountsMetres(int frame) {
        assertThat(MissionPath.isKnownFrame(waypoint(frame))).isFalse();
    }

    @Test
    void aPlaceOverTerrainIsNoHomeAndIsDrivenTo() {
        MissionPath path = MissionPath.of(List.of(waypoint(11)), 1, 2, Optional.empty());

        assertThat(path.waypoints()).containsExactly(new Waypoint(45.5, 10.7, 1));
    }

    private static MissionItem waypoint(int frame) {
        return new MissionItem(0, 16, frame, 45.5, 10.7, 3, 0, 0, 0, 0);
    }
}
