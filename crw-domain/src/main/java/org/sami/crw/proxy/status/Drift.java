package org.sami.crw.proxy.status;

import java.util.Locale;
import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/**
 * The drift of a boat that does not drive, by its reported positions.
 *
 * @param speedMps over ground in m/s; 0 where the noise of the position hides it
 * @param courseRad direction of the drift in radians clockwise from true north; 0 without a speed
 * @param leftAt where the boat began to rest or to hold its place, WGS 84
 * @param awayM its distance from there now, in metres
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
