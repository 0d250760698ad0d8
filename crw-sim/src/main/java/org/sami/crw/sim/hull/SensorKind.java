package org.sami.crw.sim.hull;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/** What simulated sensors measure, and within what bounds it varies over the water. */
public enum SensorKind {
    /** Temperature of the water. */
    TEMPERATURE("°C", 18, 4),
    /** Electrical conductivity of the water. */
    CONDUCTIVITY("µS/cm", 400, 150),
    /** Dissolved oxygen. */
    OXYGEN("mg/L", 8, 3),
    /** Acidity. */
    PH("", 7.6, 0.5);

    private final String unit;
    private final double mean;
    private final double spread;

    SensorKind(String unit, double mean, double spread) {
        this.unit = unit;
        this.mean = mean;
        this.spread = spread;
    }

    /** The unit of its readings; empty for none. */
    public String unit() {
        return unit;
    }

    /** What is measured far from everything. */
    public double mean() {
        return mean;
    }

    /** How far single patches of water differ from that at most, either way. */
    public double spread() {
        return spread;
    }

    /** Its word on the command line and in readings. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /**
     * The kind of a word.
     *
     * @throws IllegalArgumentException naming the words that there are
     */
    public static SensorKind of(String word) {
        for (SensorKind kind : values()) {
            if (kind.word().equals(word)) {
                return kind;
            }
        }
        throw new IllegalArgumentException("there is no sensor '" + word + "'; there are "
                + Arrays.stream(values()).map(SensorKind::word).collect(Collectors.joining(", ")));
    }
}
