package org.sami.crw.mavlink;

import org.sami.boat.link.Waypoint;

/**
 * The waypoint to which a vehicle is under way by itself.
 *
 * @param listId the list to which it belongs
 * @param index its number in the list
 * @param speedMps of the leg to it
 * @param isLast whether the vehicle keeps its place there
 */
record VehicleTarget(String listId, int index, Waypoint place, double speedMps, boolean isLast) {
    boolean isSame(VehicleTarget other) {
        return listId.equals(other.listId) && index == other.index;
    }
}
