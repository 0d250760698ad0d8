package org.sami.crw.gui.sound;

import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.operator.alarm.Alarm;

/** Which alarm is heard when: the worst that sounds, at once when it begins, and a critical or high one again until it ends. For one thread. */
public final class AlarmTimes {
    private static final long CRITICAL_AGAIN_MILLIS = 3_000;
    private static final long HIGH_AGAIN_MILLIS = 10_000;

    private final Set<Long> heard = new HashSet<>();
    private long lastMillis = Long.MIN_VALUE / 2;

    /**
     * What is to be heard now.
     *
     * @param nowMillis on any clock that never goes back
     * @return empty where nothing is to be heard
     */
    public Optional<AlarmTone> next(List<Alarm> alarms, long nowMillis) {
        List<Alarm> sounding = alarms.stream()
                .filter(alarm -> alarm.sounds() && tone(alarm).isPresent())
                .toList();
        heard.retainAll(sounding.stream().map(Alarm::number).toList());
        Optional<AlarmTone> fresh = worst(sounding.stream()
                .filter(alarm -> !heard.contains(alarm.number()))
                .toList());
        Optional<AlarmTone> due =
                fresh.or(() -> worst(sounding).filter(tone -> nowMillis - lastMillis >= againMillis(tone)));
        due.ifPresent(tone -> {
            lastMillis = nowMillis;
            sounding.forEach(alarm -> heard.add(alarm.number()));
        });
        return due;
    }

    /** After how long a tone sounds again while its cause lasts. */
    private static long againMillis(AlarmTone tone) {
        return switch (tone) {
            case CRITICAL -> CRITICAL_AGAIN_MILLIS;
            case HIGH -> HIGH_AGAIN_MILLIS;
            case MEDIUM -> Long.MAX_VALUE; // once
        };
    }

    private static Optional<AlarmTone> tone(Alarm alarm) {
        return AlarmTone.of(alarm.kind().severity());
    }

    private static Optional<AlarmTone> worst(List<Alarm> alarms) {
        return alarms.stream().map(AlarmTimes::tone).flatMap(Optional::stream).min(Comparator.naturalOrder());
    }
}
