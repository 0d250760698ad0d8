package org.sami.crw.sim.experiment.table;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;

/** What is measured of a run. */
public enum Measure {
    /** From the first start to the last end, in seconds. */
    TIME,
    /** The operator's clicks. */
    CLICKS,
    /** Batteries that were changed. */
    RECHARGES,
    /** From a press until the last boat has resolved it, in seconds. */
    RESOLUTION,
    /** Readings of which none is within 1 m of another. */
    MEASUREMENTS;

    /** The measure of a word, such as {@code clicks}. */
    public static Optional<Measure> of(String word) {
        return Arrays.stream(values()).filter(one -> one.word().equals(word)).findFirst();
    }

    /** The word in files and tables. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Its value in a run; empty where the run has none. */
    OptionalDouble of(RunRow row) {
        return switch (this) {
            case TIME -> OptionalDouble.of(row.seconds());
            case CLICKS -> OptionalDouble.of((double) row.clicks());
            case RECHARGES -> OptionalDouble.of(row.recharges());
            case RESOLUTION -> row.resolution();
            case MEASUREMENTS -> OptionalDouble.of(row.measurements());
        };
    }
}
