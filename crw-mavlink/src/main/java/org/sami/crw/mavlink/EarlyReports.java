package org.sami.crw.mavlink;

import java.util.ArrayList;
import java.util.List;
import org.sami.mavlink.vehicle.VehicleEvent;

/**
 * What a vehicle reports of its mission after it has taken the item to which it is sent, and before a heartbeat tells that it follows the mission: autopilots tell
 * their mode once a second, and a waypoint where the vehicle is already is reached before that. For the gateway's thread.
 */
final class EarlyReports {
    private static final int MOST = 100; // more does not come within a second

    private final List<VehicleEvent> kept = new ArrayList<>();
    private boolean isSent;

    /** It has taken the item to which it is sent: what it reports from now on is of this drive. */
    void sent() {
        kept.clear();
        isSent = true;
    }

    /** It is not sent there any longer: what was kept says nothing. */
    void forget() {
        kept.clear();
        isSent = false;
    }

    /** Takes a report, where it has been sent there. */
    void keep(VehicleEvent event) {
        if (isSent && kept.size() < MOST) {
            kept.add(event);
        }
    }

    /** It is heard to follow its mission: gives what was kept until then, in order, once. */
    List<VehicleEvent> take() {
        List<VehicleEvent> all = List.copyOf(kept);
        forget();
        return all;
    }
}
