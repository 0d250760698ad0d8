package org.sami.crw.report;

import java.util.Objects;

/**
 * How near two boats came to one another.
 *
 * @param boat one of them
 * @param other the other
 * @param atMillis time of the run at which they were nearest, for the first time
 * @param distanceM metres between them then
 * @param where halfway between them
 */
public record Approach(String boat, String other, long atMillis, double distanceM, MapPoint where) {
    public Approach {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(other, "other");
        Objects.requireNonNull(where, "where");
    }
}
