package org.sami.crw.proxy;

import java.util.Objects;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/**
 * Go to a point and stay there: a boat that is found farther away than the radius goes back to the point. It is never complete; it ends
 * when its mission wants something else of the boat, or nothing any longer.
 *
 * @param radiusM how far the boat may drift, in metres; the boat itself may keep closer
 */
public record KeepStation(
        String commandId,
        long mission,
        long activation,
        GeoPoint point,
        double radiusM,
        Priority priority,
        boolean block)
        implements BoatCommand {

    /** Refuses a radius that is not positive. */
    public KeepStation {
        CommandChecks.check(commandId, priority);
        Objects.requireNonNull(point, "point");
        if (!(radiusM > 0 && radiusM < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("a radius of " + radiusM + " m");
        }
    }

    /** The way there. */
    FollowPath way() {
        return FollowPath.goTo(commandId, mission, activation, point, priority);
    }
}
