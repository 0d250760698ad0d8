package org.sami.crw.sim.hull;

import java.util.Objects;
import java.util.OptionalDouble;
import org.sami.spn.value.TextNumbers;

/**
 * One sensor on a simulated hull.
 *
 * @param hz readings a second, {@link #LEAST_HZ} to {@link #MOST_HZ}
 */
public record SensorSetting(SensorKind kind, double hz) {
    /** The slowest rate: a reading an hour. */
    public static final double LEAST_HZ = 1.0 / 3600;

    /** The fastest rate: a boat is ticked ten times a second. */
    public static final double MOST_HZ = 10;

    private static final String AT = "@";

    /** Refuses a rate that no boat has. */
    public SensorSetting {
        Objects.requireNonNull(kind, "kind");
        if (!(hz >= LEAST_HZ && hz <= MOST_HZ)) {
            throw new IllegalArgumentException("a sensor is read 1/3600 to 10 times a second, not " + hz);
        }
    }

    /** Time between two readings in ms. */
    long periodMs() {
        return Math.round(1000 / hz);
    }

    /**
     * Reads a kind and, if not one a second, its rate: {@code oxygen} or {@code oxygen@0.2}.
     *
     * @throws IllegalArgumentException saying what is expected, if it is none
     */
    public static SensorSetting parse(String text) {
        String[] parts = text.split(AT, -1);
        OptionalDouble hz = parts.length == 2 ? TextNumbers.real(parts[1]) : OptionalDouble.of(1);
        if (parts.length <= 2 && hz.isPresent()) {
            return new SensorSetting(SensorKind.of(parts[0]), hz.getAsDouble());
        }
        throw new IllegalArgumentException(
                "expected is a sensor, or a sensor, @ and readings a second, such as oxygen@0.2, not '" + text + "'");
    }

    /** What {@link #parse} reads. */
    @Override
    public String toString() {
        return kind.word() + AT + hz;
    }
}
