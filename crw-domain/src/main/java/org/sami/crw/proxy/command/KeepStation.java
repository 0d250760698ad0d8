package org.sami.crw.proxy.command;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.service.water.Water;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/**
 * Go to a point and stay there: a boat that is found farther away than the radius goes back to the point. It is never complete; it ends
 * when its mission wants something else of the boat, or nothing any longer.
 *
 * @param radiusM how far the boat may drift, in metres; the boat itself may keep closer
 * @param water where the boat may go on its way there; empty = everywhere
 */
public record KeepStation(
        String commandId,
        long mission,
        long activation,
        GeoPoint point,
        double radiusM,
        Priority priority,
        boolean block,
        Optional<Water> water)
        implements BoatCommand {

    /** Refuses a radius that is not positive. */
    public KeepStation {
        CommandChecks.check(commandId, priority);
        Objects.requireNonNull(point, "point");
        Objects.requireNonNull(water, "water");
        if (!(radiusM > 0 && radiusM < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("a radius of " + radiusM + " m");
        }
    }

    /** A station in open water. */
    public KeepStation(
            String commandId,
            long mission,
            long activation,
            GeoPoint point,
            double radiusM,
            Priority priority,
            boolean block) {
        this(commandId, mission, activation, point, radiusM, priority, block, Optional.empty());
    }

    @Override
    public List<GeoPoint> points() {
        return List.of(point);
    }

    @Override
    public KeepStation in(Water limits) {
        return new KeepStation(commandId, mission, activation, point, radiusM, priority, block, Optional.of(limits));
    }

    /** The way there. */
    public FollowPath way() {
        FollowPath way = FollowPath.goTo(commandId, mission, activation, point, priority);
        return water.map(way::in).orElse(way);
    }
}
