package org.sami.mavlink.base;

import io.dronefleet.mavlink.common.RequestDataStream;
import org.sami.mavlink.vehicle.VehicleId;

/** Asks a vehicle to send nothing by itself on a link but heartbeats, answers and texts: what it streams unasked would fill a slow link. */
final class Silence {
    private Silence() {}

    /** The message of the library that says so. */
    @SuppressWarnings("deprecation") // ArduPilot has no later one that stops all streams
    static Object of(VehicleId vehicle) {
        return RequestDataStream.builder()
                .targetSystem(vehicle.system())
                .targetComponent(vehicle.component())
                .reqStreamId(0)
                .reqMessageRate(0)
                .startStop(0)
                .build();
    }
}
