package org.sami.crw.proxy.command;

import java.util.List;
import java.util.Optional;
import org.sami.crw.service.water.Water;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** What a mission wants one boat to do. */
public sealed interface BoatCommand permits FollowPath, KeepStation, Panorama, Stop {

    /**
     * Names this command among all that the boat ever gets, by a rule of the caller that a repeated run follows again, such
     * as {@code m3-a17-boat2}.
     */
    String commandId();

    /** The mission that wants it. */
    long mission();

    /** The activation that asked for it. */
    long activation();

    /** Its rank in the boat's queue. */
    Priority priority();

    /**
     * Whether the boat is kept for this mission from the moment the command runs until the mission ends: commands of other
     * missions then wait, but for critical ones.
     */
    boolean block();

    /** The points to which it sends the boat, in driving order; none where it sends it nowhere. */
    default List<GeoPoint> points() {
        return List.of();
    }

    /** Those of the points that are not visited yet when it begins. */
    default List<GeoPoint> unvisitedPoints() {
        return points();
    }

    /** Where the boat may go meanwhile; empty = everywhere. */
    default Optional<Water> water() {
        return Optional.empty();
    }

    /** The same command for a boat that may not go everywhere; unchanged where it sends the boat nowhere. */
    default BoatCommand in(Water limits) {
        return this;
    }
}
