package org.sami.crw.gui.sound;

import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.operator.alarm.Alarm;

/** Which alarm is heard when: the worst that sounds, at once when it begins, and again as often as its tone says. For one thread. */
public final class AlarmTimes {
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
                fresh.or(() -> worst(sounding).filter(tone -> nowMillis - lastMillis >= tone.againMillis()));
        due.ifPresent(tone -> {
            lastMillis = nowMillis;
            sounding.forEach(alarm -> heard.add(alarm.number()));
        });
        return due;
    }

    private static Optional<AlarmTone> tone(Alarm alarm) {
        return AlarmTone.of(alarm.kind().severity());
    }

    private static Optional<AlarmTone> worst(List<Alarm> alarms) {
        return alarms.stream().map(AlarmTimes::tone).flatMap(Optional::stream).min(Comparator.naturalOrder());
    }
}
