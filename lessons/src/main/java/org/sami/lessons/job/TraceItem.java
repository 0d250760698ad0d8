package org.sami.lessons.job;

import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;

/**
 * One thing that could be seen from outside: an output event for one robot or task, or for whoever entered where it asks for all of them
 * together. Ids and names of the plan do not occur.
 *
 * @param atMillis since the start of the mission
 * @param robots in alphabetical order
 * @param tasks by the order of their making, from 1
 * @param values of fields, written so that equal text means equal
 */
public record TraceItem(
        long atMillis, String type, List<String> robots, List<Integer> tasks, Map<String, String> values) {
    /** Instant first, then everything else. */
    static final Comparator<TraceItem> ORDER =
            Comparator.comparingLong(TraceItem::atMillis).thenComparing(TraceItem::inInstant);

    public TraceItem {
        Objects.requireNonNull(type, "type");
        robots = robots.stream().sorted().toList();
        tasks = tasks.stream().sorted().toList();
        values = Collections.unmodifiableMap(new TreeMap<>(values));
    }

    private String inInstant() {
        return type + " " + robots + " " + tasks + " " + values;
    }

    /** Whether it is the same event for the same robots and tasks, whatever the time and the values. */
    boolean isLike(TraceItem other) {
        return type.equals(other.type) && robots.equals(other.robots) && tasks.equals(other.tasks);
    }
}
