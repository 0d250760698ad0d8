package org.sami.crw.proxy.status;

import java.util.Locale;
import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/**
 * How a boat that does not drive is carried over ground, by the positions that it told.
 *
 * @param speedMps over ground in m/s; 0 where it is too slow to be told from the noise of its position
 * @param courseRad where it is carried to, in radians clockwise from true north; 0 without a speed
 * @param leftAt where it was when it began to rest or to hold its place, WGS 84
 * @param awayM how far it is from there now, in metres
 */
public record Drift(double speedMps, double courseRad, GeoPoint leftAt, double awayM) {
    private static final String[] COURSES = {
        "north", "northeast", "east", "southeast", "south", "southwest", "west", "northwest"
    };

    public Drift {
        Objects.requireNonNull(leftAt, "leftAt");
    }

    /** Whether it is carried for sure. */
    public boolean isMoving() {
        return speedMps > 0;
    }

    /** Such as {@code drifts 0.25 m/s to the east}; only of one that moves. */
    public String words() {
        int sector = Math.floorMod((int) Math.round(courseRad / (Math.PI / 4)), COURSES.length);
        return String.format(Locale.ROOT, "drifts %.2f m/s to the %s", speedMps, COURSES[sector]);
    }
}
