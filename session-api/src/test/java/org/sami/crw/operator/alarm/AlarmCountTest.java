package org.sami.crw.operator.alarm;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.operator.alarm.Alarm.Kind;

/** What is over is no alarm that is open, and what is known is still one. */
class AlarmCountTest {
    private static Alarm alarm(boolean active, boolean acknowledged) {
        return new Alarm(1, Kind.LINK_LOST, "anna", "", "The link to anna is lost", 0, active, acknowledged, false);
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0, 0, no alarms",
        "1, 0, 0, 1 alarm",
        "2, 0, 1, 2 alarms · 1 over",
        "0, 0, 1, 1 alarm over",
        "0, 2, 0, 2 known alarms",
        "1, 1, 2, 1 alarm · 1 known · 2 over",
    })
    void openKnownAndOverAreCountedApart(int open, int known, int over, String words) {
        List<Alarm> alarms = new ArrayList<>();
        for (int i = 0; i < open; i++) {
            alarms.add(alarm(true, false));
        }
        for (int i = 0; i < known; i++) {
            alarms.add(alarm(true, true));
        }
        for (int i = 0; i < over; i++) {
            alarms.add(alarm(false, false));
        }

        assertThat(AlarmCount.of(alarms).words()).isEqualTo(words);
    }
}
