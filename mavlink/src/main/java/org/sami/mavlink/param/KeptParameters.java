package org.sami.mavlink.param;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/**
 * The parameters of a vehicle as they were once. They say nothing of what it holds now: others may have changed it.
 *
 * @param since when they were kept
 */
public record KeptParameters(Instant since, SortedMap<String, Double> values) {
    private static final String COUNTERS = "STAT_"; // the autopilot's own, of starts and hours

    /** Parameters. */
    public KeptParameters {
        Objects.requireNonNull(since, "since");
        values = new TreeMap<>(values);
    }

    /** What has changed since, in the order of the names, such as {@code FENCE_ENABLE 1 → 0}; without the autopilot's counters of starts and hours. */
    public List<String> changes(SortedMap<String, Double> now) {
        TreeSet<String> names = new TreeSet<>(values.keySet());
        names.addAll(now.keySet());
        return names.stream()
                .filter(name -> !name.startsWith(COUNTERS))
                .filter(name -> !text(values.get(name)).equals(text(now.get(name))))
                .map(name -> name + " " + text(values.get(name)) + " → " + text(now.get(name)))
                .toList();
    }

    private static String text(@Nullable Double value) {
        return value == null ? "not there" : written(value);
    }

    /** A value as it stands in a file. */
    static String written(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15
                ? Long.toString((long) value)
                : Float.toString((float) value);
    }
}
