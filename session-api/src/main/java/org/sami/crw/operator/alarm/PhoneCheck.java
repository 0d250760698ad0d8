package org.sami.crw.operator.alarm;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.boat.link.PhoneReadings;
import org.sami.crw.operator.alarm.Alarm.Kind;
import org.sami.crw.proxy.status.BoatReading;

/**
 * Judges what boats report of their phones: heat, storage, log and date. An alarm ends only when its value is clearly better than the limit, so that a value
 * near the limit does not raise a series of alarms. For one thread.
 */
final class PhoneCheck {
    private static final double COOL_AGAIN_C = PhoneReadings.HOT_C - 2;
    private static final double ROOM_AGAIN_MB = PhoneReadings.LITTLE_STORAGE_MB * 1.1;

    /** A fault that a phone repeats while it lasts is over after this time without a reading (three periods). */
    private static final long REPEATED_WITHIN_MS = 3 * PhoneReadings.PERIOD_MS;

    /** A date that was set, which is reported once, is an alarm for this time. */
    private static final long DATE_SET_FOR_MS = 60_000;

    private final Set<Subject> active = new HashSet<>();
    private final Map<Subject, Long> untilMillis = new HashMap<>();

    /** An alarm of a kind about the phone of a boat. */
    record Subject(Kind kind, String boat) {}

    /**
     * What follows from a reading.
     *
     * @return the kind that it decides on, with the text of the alarm, or without one where nothing is wrong; empty for a reading that decides on none
     */
    Map<Kind, Optional<String>> measured(String boat, BoatReading reading, long atMillis) {
        if (!reading.sensor().equals(PhoneReadings.SENSOR)) {
            return Map.of();
        }
        double value = reading.values().get(0);
        return switch (reading.channel()) {
            case PhoneReadings.TEMPERATURE ->
                limited(
                        new Subject(Kind.PHONE_HOT, boat),
                        value >= PhoneReadings.HOT_C,
                        value < COOL_AGAIN_C,
                        "The phone of " + boat + " is hot: " + Math.round(value) + " °C");
            case PhoneReadings.FREE_STORAGE ->
                limited(
                        new Subject(Kind.PHONE_STORAGE, boat),
                        value < PhoneReadings.LITTLE_STORAGE_MB,
                        value >= ROOM_AGAIN_MB,
                        "The storage of " + boat + "'s phone is nearly full: " + Math.round(value) + " MB are left");
            case PhoneReadings.LOG_BROKEN ->
                lasting(
                        new Subject(Kind.PHONE_LOG, boat),
                        atMillis + REPEATED_WITHIN_MS,
                        boat + " cannot write its log: after a restart it will not know its last commands");
            case PhoneReadings.LOG_TOO_LARGE ->
                lasting(
                        new Subject(Kind.PHONE_LOG, boat),
                        atMillis + REPEATED_WITHIN_MS,
                        boat + " can begin no new file of its log: the log grows beyond its size");
            case PhoneReadings.DATE_LOST ->
                lasting(
                        new Subject(Kind.PHONE_DATE, boat),
                        atMillis + REPEATED_WITHIN_MS,
                        "The phone of " + boat + " has lost its date: its logs have wrong times");
            case PhoneReadings.DATE_SET_BY ->
                lasting(
                        new Subject(Kind.PHONE_DATE, boat),
                        atMillis + DATE_SET_FOR_MS,
                        "The date of " + boat + "'s phone was set " + words(value)
                                + ": its logs have two times; it drives as before");
            default -> Map.of();
        };
    }

    private static String words(double bySeconds) {
        double seconds = Math.abs(bySeconds);
        String by = seconds < 120
                ? String.format(Locale.ROOT, "%.0f s", seconds)
                : seconds < 172_800
                        ? String.format(Locale.ROOT, "%.0f min", seconds / 60)
                        : String.format(Locale.ROOT, "%.0f days", seconds / 86_400);
        return by + (bySeconds < 0 ? " back" : " forward");
    }

    private Map<Kind, Optional<String>> limited(Subject subject, boolean wrong, boolean well, String text) {
        boolean goesOn = active.contains(subject) && !well;
        if (wrong || goesOn) {
            active.add(subject);
            return Map.of(subject.kind(), Optional.of(text));
        }
        active.remove(subject);
        return Map.of(subject.kind(), Optional.empty());
    }

    private Map<Kind, Optional<String>> lasting(Subject subject, long until, String text) {
        untilMillis.merge(subject, until, Math::max);
        return Map.of(subject.kind(), Optional.of(text));
    }

    /** Alarms that are over because their readings have stopped; each is returned once. */
    Set<Subject> over(long nowMillis) {
        Set<Subject> over = new HashSet<>();
        untilMillis.entrySet().removeIf(entry -> entry.getValue() < nowMillis && over.add(entry.getKey()));
        return over;
    }

    void remove(String boat) {
        active.removeIf(subject -> subject.boat().equals(boat));
        untilMillis.keySet().removeIf(subject -> subject.boat().equals(boat));
    }
}
