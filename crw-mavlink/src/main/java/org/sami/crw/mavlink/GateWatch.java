package org.sami.crw.mavlink;

import java.util.Optional;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * Notices a vehicle that stays where its part of a list ended ({@link MissionWindow}) although the next part is there: autopilots go on by themselves where they
 * see that the item under way is another. One that moves is left alone, as it may be past that item before an order reaches it. For the gateway's thread.
 */
final class GateWatch {
    private static final long PATIENCE_MS = 3_000;
    private static final double STILL_MPS = 0.15;

    private Optional<Integer> gate = Optional.empty(); // its number in the mission of the vehicle
    private long sinceMs = Long.MAX_VALUE;

    /** The gate of this number has been replaced by the item that belongs there. */
    void opened(int number) {
        gate = Optional.of(number);
        sinceMs = Long.MAX_VALUE;
    }

    /** The number of the item to go on at, of a vehicle that is seen to stay there; once. To be called often. */
    Optional<Integer> stays(VehicleSnapshot vehicle, long atMs) {
        if (gate.isEmpty()) {
            return Optional.empty();
        }
        sinceMs = Math.min(sinceMs, atMs);
        if (!vehicle.currentItem().equals(gate)) {
            gate = Optional.empty();
        } else if (atMs - sinceMs >= PATIENCE_MS) {
            boolean isStill = vehicle.position().map(VehiclePosition::speedMps).orElse(0.0) < STILL_MPS;
            Optional<Integer> number = gate.filter(one -> isStill);
            gate = Optional.empty();
            return number;
        }
        return Optional.empty();
    }
}
