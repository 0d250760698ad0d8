package org.sami.spn.vocabulary;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Which values of its type a field can have in its domain, for the checks of plans.
 *
 * @param range numbers outside of which no handler accepts; of durations in seconds
 * @param usual numbers outside of which a value is probably a mistake; of durations in seconds
 * @param above another field of the event whose number is less than this one's
 * @param words the texts that mean something; empty where every text does
 */
public record FieldLimits(Range range, Range usual, Optional<String> above, List<String> words) {
    /** Every value of the type. */
    public static final FieldLimits NONE = new FieldLimits(Range.ALL, Range.ALL, Optional.empty(), List.of());

    public FieldLimits {
        Objects.requireNonNull(range, "range");
        Objects.requireNonNull(usual, "usual");
        Objects.requireNonNull(above, "above");
        words = List.copyOf(words);
    }

    /** Numbers from a least to a greatest, both included. */
    public record Range(double least, double most) {
        /** All numbers. */
        public static final Range ALL = new Range(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

        public Range {
            if (!(least <= most)) {
                throw new IllegalArgumentException("Not a range: " + least + " to " + most);
            }
        }

        /** Whether a number lies in this range. */
        public boolean contains(double number) {
            return number >= least && number <= most;
        }
    }
}
