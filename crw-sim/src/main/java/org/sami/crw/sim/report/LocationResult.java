package org.sami.crw.sim.report;

import java.util.Objects;
import java.util.OptionalLong;

/**
 * A location that the operator gave.
 *
 * @param number from 1, in the order in which they were given
 * @param eastM metres east of the area's centre
 * @param northM metres north of the area's centre
 * @param visitedAtMillis simulated time at which the first boat came there; empty = not visited
 * @param visitedBy that boat, else empty text
 */
public record LocationResult(
        int number,
        double latDeg,
        double lonDeg,
        double eastM,
        double northM,
        OptionalLong visitedAtMillis,
        String visitedBy) {
    public LocationResult {
        Objects.requireNonNull(visitedAtMillis, "visitedAtMillis");
        Objects.requireNonNull(visitedBy, "visitedBy");
    }

    /** Whether a boat was there. */
    public boolean visited() {
        return visitedAtMillis.isPresent();
    }
}
