package org.sami.crw.proxy;

/**
 * The charge that an aircraft was seen to use in the air. Immutable.
 *
 * @param percent charge in percent of full, 0 or more
 * @param seconds in which it was used, 0 or more
 */
public record FlightUsed(double percent, double seconds) {
    /** Refuses what nobody can have seen. */
    public FlightUsed {
        if (!(percent >= 0
                && seconds >= 0
                && percent < Double.POSITIVE_INFINITY
                && seconds < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("an aircraft does not use " + percent + " % in " + seconds + " s");
        }
    }
}
