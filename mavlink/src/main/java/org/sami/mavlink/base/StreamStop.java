package org.sami.mavlink.base;

import io.dronefleet.mavlink.common.RequestDataStream;
import org.sami.mavlink.vehicle.VehicleId;

/** Asks a vehicle to stop its own streams on a link, which would fill a slow one; heartbeats, answers and texts still come. */
final class StreamStop {
    private StreamStop() {}

    /** The message that asks for it. */
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
