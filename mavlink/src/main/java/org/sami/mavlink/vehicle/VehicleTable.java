package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavType;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.mavlink.address.MavlinkAddress;

/** The vehicles that have been heard on the links of a base. Used by one thread. */
public final class VehicleTable {
    private final TreeMap<VehicleId, VehicleRecord> vehicles = new TreeMap<>();

    /** A message came from a component of a system; one that is no autopilot (a ground station, a gimbal, a radio) makes no vehicle. */
    public void heard(MavlinkAddress on, int system, int component, Object payload, long nowMs) {
        VehicleId id = new VehicleId(system, component);
        if (payload instanceof Heartbeat beat && isVehicle(beat)) {
            vehicles.computeIfAbsent(id, VehicleRecord::new);
        }
        VehicleRecord known = vehicles.get(id);
        if (known != null) {
            known.heard(on, payload, nowMs);
        }
    }

    private static boolean isVehicle(Heartbeat beat) {
        return beat.autopilot().entry() != MavAutopilot.MAV_AUTOPILOT_INVALID
                && beat.type().entry() != MavType.MAV_TYPE_GCS;
    }

    /** All vehicles, by their ids. */
    public List<VehicleSnapshot> vehicles() {
        return vehicles.values().stream().map(VehicleRecord::snapshot).toList();
    }

    /** Whether a vehicle of this id has been heard. */
    public boolean has(VehicleId id) {
        return vehicles.containsKey(id);
    }

    /** The link on which a vehicle was heard last; empty where it was not. */
    public Optional<MavlinkAddress> linkOf(VehicleId id) {
        return Optional.ofNullable(vehicles.get(id))
                .map(known -> known.snapshot().links().get(0));
    }
}
