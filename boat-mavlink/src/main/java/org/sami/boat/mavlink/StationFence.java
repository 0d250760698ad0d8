package org.sami.boat.mavlink;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Where a boat may be by the fence that a ground station gave it: in no exclusion zone, and, where there are inclusion zones, in all of one group of them.
 * Immutable.
 *
 * <p>Source: the commands MAV_CMD_NAV_FENCE_* of MAVLink's documentation.
 *
 * @param zones in the order in which the ground station sent them
 */
record StationFence(List<Zone> zones) {
    /** A fence that lets a boat be everywhere. */
    static final StationFence NONE = new StationFence(List.of());

    private static final double SHORTEST_PART = 1e-9; // of a way; where it meets a corner, it crosses two edges at once

    /**
     * A zone.
     *
     * @param isInclusion whether the boat must stay in it, or else out of it
     * @param group of inclusion zones: the boat must be in all zones of one group
     */
    record Zone(FenceShape shape, boolean isInclusion, int group) {}

    /** A fence. */
    StationFence {
        zones = List.copyOf(zones);
    }

    /** Whether a boat may be at a place. */
    boolean isInside(Position at) {
        if (zones.stream().anyMatch(zone -> !zone.isInclusion && zone.shape.contains(at))) {
            return false;
        }
        Map<Integer, Boolean> groups = zones.stream()
                .filter(Zone::isInclusion)
                .collect(Collectors.toMap(Zone::group, zone -> zone.shape.contains(at), Boolean::logicalAnd));
        return groups.isEmpty() || groups.containsValue(true);
    }

    /** Whether a straight way ends outside, or leaves the fence after it was inside; a way that begins outside may lead in. */
    boolean leadsOut(Position from, Position to) {
        List<Double> ends = new ArrayList<>(List.of(0.0, 1.0));
        zones.forEach(zone -> zone.shape.crossings(from, to, ends::add));
        Collections.sort(ends);
        boolean wasInside = isInside(from);
        for (int i = 1; i < ends.size(); i++) {
            double begin = ends.get(i - 1);
            double end = ends.get(i);
            if (end - begin > SHORTEST_PART) {
                boolean inside = isInside(from.towards(to, (begin + end) / 2));
                if (wasInside && !inside) {
                    return true;
                }
                wasInside = inside;
            }
        }
        return !isInside(to);
    }
}
