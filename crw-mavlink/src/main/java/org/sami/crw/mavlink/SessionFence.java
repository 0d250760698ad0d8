package org.sami.crw.mavlink;

import java.util.List;
import org.sami.mavlink.mission.MissionItem;

/**
 * The area of a session as a fence of vehicles.
 *
 * @param items none where everything is allowed
 * @param bindsCopters whether copters are to hold it; where boats are, it bounds the water, and a copter that starts on the shore would be outside of it
 */
record SessionFence(List<MissionItem> items, boolean bindsCopters) {
    /** No session has given an area. */
    static final SessionFence NONE = new SessionFence(List.of(), false);

    SessionFence {
        items = List.copyOf(items);
    }

    /** What a vehicle is to hold. */
    List<MissionItem> of(boolean flies) {
        return flies && !bindsCopters ? List.of() : items;
    }
}
