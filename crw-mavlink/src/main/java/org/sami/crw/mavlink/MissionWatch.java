package org.sami.crw.mavlink;

import java.util.Optional;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * Notices that somebody else has replaced the mission that a vehicle holds, by the number of items that it reports once a second. A mission of as many items is
 * not noticed. For the gateway's thread.
 */
final class MissionWatch {
    private boolean isSeen; // the vehicle has reported the number of items that it was given

    /** It is given another mission: what it reports until it has that says nothing. */
    void forget() {
        isSeen = false;
    }

    /**
     * Whether it reports another number of items than it was given and reported before. Said once.
     *
     * @param items that it was given, home included, which ArduPilot does not count
     */
    boolean isReplaced(int items, VehicleSnapshot vehicle) {
        Optional<Integer> reported = vehicle.itemsHeld();
        if (reported.isEmpty()) { // an older firmware
            return false;
        }
        boolean isSame = reported.get() == items || reported.get() == items - 1;
        boolean isReplaced = isSeen && !isSame;
        isSeen = isSame;
        return isReplaced;
    }
}
