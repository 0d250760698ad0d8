package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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
}
