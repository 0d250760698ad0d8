package org.sami.crw.mavlink;

import java.util.Optional;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * Detects a vehicle that stays where its part of a list ended ({@link MissionWindow}) although it has the next part: most autopilots go on by themselves once the
 * item under way has been replaced. A vehicle that moves is not reported, as it may pass that item before an order reaches it. For the gateway's thread.
 */
final class StalledListDetector {
    private static final long PATIENCE_MS = 3_000;
    private static final double STILL_MPS = 0.15;

    private Optional<Integer> stop = Optional.empty(); // its number in the mission of the vehicle
    private long sinceMs = Long.MAX_VALUE;

    /** The stop of this number has been replaced by the item that belongs there. */
    void stopReplaced(int number) {
        stop = Optional.of(number);
        sinceMs = Long.MAX_VALUE;
    }

    /** The number of the item at which a stalled vehicle is to go on, once; empty where it is not stalled. To be called at each tick. */
    Optional<Integer> stays(VehicleSnapshot vehicle, long atMs) {
        if (stop.isEmpty()) {
            return Optional.empty();
        }
        sinceMs = Math.min(sinceMs, atMs);
        if (!vehicle.currentItem().equals(stop)) {
            stop = Optional.empty();
        } else if (atMs - sinceMs >= PATIENCE_MS) {
            boolean isStill = vehicle.position().map(VehiclePosition::speedMps).orElse(0.0) < STILL_MPS;
            Optional<Integer> number = stop.filter(one -> isStill);
            stop = Optional.empty();
            return number;
        }
        return Optional.empty();
    }
}
