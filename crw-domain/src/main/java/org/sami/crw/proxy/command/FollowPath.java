package org.sami.crw.proxy.command;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.crw.service.water.Water;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/**
 * Drive along a path; complete when its last point is reached, and at once if none is left.
 *
 * @param points in driving order; altitudes, in metres above the take-off, count for what flies
 * @param speedMps speed in m/s; the fleet's cruise speed if empty
 * @param startIndex the first point that has not been visited yet; those before it are not driven to
 * @param water where the boat may go: legs that would leave it turn around what is in their way; empty = everywhere
 */
public record FollowPath(
        String commandId,
        long mission,
        long activation,
        List<GeoPoint> points,
        OptionalDouble speedMps,
        int startIndex,
        Priority priority,
        boolean block,
        Optional<Water> water)
        implements BoatCommand {

    /** Refuses a start behind the end of the path and a speed that is not positive. */
    public FollowPath {
        CommandChecks.check(commandId, priority);
        points = List.copyOf(points);
        Objects.requireNonNull(speedMps, "speedMps");
        Objects.requireNonNull(water, "water");
        if (startIndex < 0 || startIndex > points.size()) {
            throw new IllegalArgumentException("a start at " + startIndex + " of " + points.size() + " points");
        }
        if (speedMps.isPresent() && !(speedMps.getAsDouble() > 0 && speedMps.getAsDouble() <= 50)) {
            throw new IllegalArgumentException("a speed of " + speedMps.getAsDouble() + " m/s");
        }
    }

    /** A path in open water. */
    public FollowPath(
            String commandId,
            long mission,
            long activation,
            List<GeoPoint> points,
            OptionalDouble speedMps,
            int startIndex,
            Priority priority,
            boolean block) {
        this(commandId, mission, activation, points, speedMps, startIndex, priority, block, Optional.empty());
    }

    /** A path from its first point, at cruise speed, that does not block. */
    public static FollowPath of(
            String commandId, long mission, long activation, List<GeoPoint> points, Priority priority) {
        return new FollowPath(commandId, mission, activation, points, OptionalDouble.empty(), 0, priority, false);
    }

    /** Go to one point: a path of one. */
    public static FollowPath goTo(String commandId, long mission, long activation, GeoPoint point, Priority priority) {
        return of(commandId, mission, activation, List.of(point), priority);
    }

    /** Whether all its points have been visited already. */
    public boolean nothingIsLeft() {
        return startIndex == points.size();
    }

    @Override
    public List<GeoPoint> unvisitedPoints() {
        return points.subList(startIndex, points.size());
    }

    /** What a boat that is somewhere drives along: the points, and those at which it turns to stay in its water. */
    public List<GeoPoint> way(GeoPoint from) {
        return DrivenPath.of(points, startIndex, Optional.of(from), water).points();
    }

    /** The same path, from its first unvisited point on. */
    public FollowPath startingAt(int index) {
        return new FollowPath(commandId, mission, activation, points, speedMps, index, priority, block, water);
    }

    /** The same path at a speed in m/s. */
    public FollowPath atSpeed(double mps) {
        return new FollowPath(
                commandId, mission, activation, points, OptionalDouble.of(mps), startIndex, priority, block, water);
    }

    /** The same command, keeping the boat for its mission. */
    public FollowPath blocking() {
        return new FollowPath(commandId, mission, activation, points, speedMps, startIndex, priority, true, water);
    }

    @Override
    public FollowPath in(Water limits) {
        return new FollowPath(
                commandId, mission, activation, points, speedMps, startIndex, priority, block, Optional.of(limits));
    }
}
