package org.sami.crw.mavlink;

import java.util.HashMap;
import java.util.Map;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** Waits for the numbers of autopilots, by which vehicles are told apart, as long as one that has a number may need to say it. For the gateway's thread. */
final class NumberWait {
    private static final long MOST_MS = 2_500; // it is asked each second

    private static final long SILENT_MS = 3_000;

    private final Map<Integer, Long> sinceMs = new HashMap<>(); // by system id

    /** Whether it has said its number or that it has none, or will not. */
    boolean isOver(VehicleSnapshot vehicle, long atMs) {
        int system = vehicle.id().system();
        boolean isSaid = vehicle.number().isPresent();
        if (isSaid || atMs - vehicle.heardMs() > SILENT_MS) { // it is asked for anew after a silence
            sinceMs.remove(system);
            return isSaid;
        }
        return atMs - sinceMs.computeIfAbsent(system, first -> atMs) >= MOST_MS;
    }
}
