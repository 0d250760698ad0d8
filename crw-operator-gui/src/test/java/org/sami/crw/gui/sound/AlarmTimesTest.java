package org.sami.crw.gui.sound;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.alarm.Alarm.Kind;

class AlarmTimesTest {
    private static final Alarm LOW_BATTERY = alarm(1, Kind.BATTERY_LOW);
    private static final Alarm LOST = alarm(2, Kind.LINK_LOST);
    private static final Alarm OUTSIDE = alarm(3, Kind.FENCE);

    private final AlarmTimes times = new AlarmTimes();

    @Test
    void theWorstIsHeardAtOnceAndAgainAsOftenAsItsToneSays() {
        assertThat(times.next(List.of(LOST), 0)).contains(AlarmTone.HIGH);
        assertThat(times.next(List.of(LOST), 9_999)).isEmpty();
        assertThat(times.next(List.of(LOST), 10_000)).contains(AlarmTone.HIGH);

        assertThat(times.next(List.of(LOST, OUTSIDE), 10_100)).contains(AlarmTone.CRITICAL);
        assertThat(times.next(List.of(LOST, OUTSIDE), 13_000)).isEmpty();
        assertThat(times.next(List.of(LOST, OUTSIDE), 13_100)).contains(AlarmTone.CRITICAL);
    }

    @Test
    void aMediumAlarmIsHeardOnce() {
        assertThat(times.next(List.of(LOW_BATTERY), 0)).contains(AlarmTone.MEDIUM);
        assertThat(times.next(List.of(LOW_BATTERY), 10_000_000)).isEmpty();
    }

    @Test
    void whatIsAcknowledgedMutedOrOverIsSilentAndHeardAnewWhenItComesBack() {
        assertThat(times.next(List.of(OUTSIDE), 0)).contains(AlarmTone.CRITICAL);
        assertThat(times.next(List.of(with(OUTSIDE, true, true, false)), 5_000)).isEmpty();
        assertThat(times.next(List.of(with(OUTSIDE, true, false, true)), 5_000)).isEmpty();
        assertThat(times.next(List.of(with(OUTSIDE, false, false, false)), 5_000))
                .isEmpty();
        assertThat(times.next(List.of(OUTSIDE), 5_100)).contains(AlarmTone.CRITICAL);
    }

    private static Alarm alarm(long number, Kind kind) {
        return new Alarm(number, kind, "anna", "", "text", 0, true, false, false);
    }

    private static Alarm with(Alarm alarm, boolean active, boolean acknowledged, boolean muted) {
        return new Alarm(
                alarm.number(),
                alarm.kind(),
                alarm.boat(),
                alarm.other(),
                alarm.text(),
                alarm.sinceMillis(),
                active,
                acknowledged,
                muted);
    }
}
