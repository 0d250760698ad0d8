package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.common.CameraTrackingGeoStatus;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavType;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.sami.mavlink.address.MavlinkAddress;

/** The vehicles that have been heard on the links of a base. Used by one thread. */
public final class VehicleTable {
    private final TreeMap<VehicleId, VehicleRecord> vehicles = new TreeMap<>();
    private final OtherStations stations = new OtherStations();
    private RadioSignals radios = RadioSignals.NONE;

    /**
     * A message came from a component of a system; one that is no autopilot (a ground station, a gimbal, a radio) makes no
     * vehicle. What the camera of a system follows is told of its vehicles. A ground station's heartbeat counts as another station's: the base leaves out its own.
     *
     * @return what happened to the vehicle by it
     */
    public List<VehicleEvent> heard(MessageOrigin from, Object payload, long nowMs) {
        VehicleId id = new VehicleId(from.system(), from.component());
        List<VehicleEvent> events = new ArrayList<>();
        VehicleRecord known = vehicles.get(id);
        if (payload instanceof Heartbeat beat && beat.type().entry() == MavType.MAV_TYPE_GCS) {
            stations.heard(from.link(), from.system(), nowMs);
        }
        if (known == null && payload instanceof Heartbeat beat && isVehicle(beat)) {
            known = new VehicleRecord(id, nowMs);
            known.links().radios(radios);
            vehicles.put(id, known);
            events.add(new VehicleEvent.Appeared(id));
        }
        if (known != null) {
            events.addAll(known.heard(from, payload, nowMs));
        }
        if (payload instanceof CameraTrackingGeoStatus target) { // its camera is a component of its own
            vehicles.keySet().stream()
                    .filter(one -> one.system() == from.system())
                    .forEach(one -> TrackedTargets.of(one, target).ifPresent(events::add));
        }
        return events;
    }

    /** Lets time pass. To be called several times a second; returns what has happened to vehicles by that. */
    public List<VehicleEvent> tick(long nowMs) {
        return vehicles.values().stream()
                .flatMap(known -> known.tick(nowMs).stream())
                .toList();
    }

    private static boolean isVehicle(Heartbeat beat) {
        return beat.autopilot().entry() != MavAutopilot.MAV_AUTOPILOT_INVALID
                && beat.type().entry() != MavType.MAV_TYPE_GCS;
    }

    /** All vehicles, by their ids. */
    public List<VehicleSnapshot> vehicles() {
        return vehicles.values().stream().map(known -> known.snapshot(stations)).toList();
    }

    /** What is known of one vehicle; empty where it was not heard. */
    public Optional<VehicleSnapshot> vehicle(VehicleId id) {
        return Optional.ofNullable(vehicles.get(id)).map(known -> known.snapshot(stations));
    }

    /** The number of a mode of a vehicle by its name; empty where it was not heard, or has none of this name. */
    public Optional<Long> modeNumber(VehicleId id, String mode) {
        return Optional.ofNullable(vehicles.get(id)).flatMap(known -> known.modeNumber(mode));
    }

    /** The ids of all vehicles, in order. */
    public Set<VehicleId> ids() {
        return Collections.unmodifiableSet(vehicles.keySet());
    }

    /** Whether a vehicle of this id has been heard. */
    public boolean has(VehicleId id) {
        return vehicles.containsKey(id);
    }

    /** Whether a vehicle was heard within a time. */
    public boolean isHeard(VehicleId id, long nowMs, long withinMs) {
        return Optional.ofNullable(vehicles.get(id))
                .filter(known -> nowMs - known.heardMs() <= withinMs)
                .isPresent();
    }

    /** Whether a vehicle goes on speaking, but has not said for seconds where it is. */
    public boolean isPositionOld(VehicleId id) {
        return Optional.ofNullable(vehicles.get(id))
                .filter(VehicleRecord::isPositionOld)
                .isPresent();
    }

    /** A vehicle's autopilot has started again, as was found out elsewhere. */
    public void restarted(VehicleId id) {
        Optional.ofNullable(vehicles.get(id)).ifPresent(VehicleRecord::restarted);
    }

    /** Whether two vehicles have this id, as far as the last seconds show. */
    public boolean sharesId(VehicleId id) {
        return Optional.ofNullable(vehicles.get(id))
                .filter(VehicleRecord::sharesId)
                .isPresent();
    }

    /** The link on which a vehicle is spoken to; empty where it was not heard. */
    public Optional<MavlinkAddress> linkOf(VehicleId id) {
        return Optional.ofNullable(vehicles.get(id))
                .flatMap(known -> known.links().chosen());
    }

    /** Whether what comes with an id on a link is not taken for the vehicle of that id: it is another one, or not recognized yet. */
    public boolean isForeign(VehicleId id, MavlinkAddress link) {
        return Optional.ofNullable(vehicles.get(id))
                .filter(known -> !known.own().has(link))
                .isPresent();
    }

    /** The links on which something speaks with a vehicle's id that is not recognized as that vehicle. */
    public List<MavlinkAddress> unsettled(VehicleId id) {
        return Optional.ofNullable(vehicles.get(id))
                .map(known -> known.own().unsettled())
                .orElse(List.of());
    }

    /** Whether a vehicle is to be asked for the number of its autopilot: it has not said it since it was heard first, was silent or has started again. */
    public boolean isNumberOpen(VehicleId id) {
        return Optional.ofNullable(vehicles.get(id))
                .filter(VehicleRecord::isNumberOpen)
                .isPresent();
    }

    /** Whether a vehicle may fall where its motors are turned off: it, or another one with its id, flies, or may fly as it was not heard just now. */
    public boolean mayFly(VehicleId id, long nowMs) {
        return Optional.ofNullable(vehicles.get(id))
                .filter(known -> !known.mayFly(nowMs))
                .isEmpty();
    }

    /** Whether a vehicle's autopilot has said its number, by which it is recognized on other links. */
    public boolean hasNumber(VehicleId id) {
        return Optional.ofNullable(vehicles.get(id))
                .filter(known -> known.own().hasNumber())
                .isPresent();
    }

    /** A link was replaced by another one at the same port: who was heard on it is expected on that one. */
    public void moved(MavlinkAddress before, MavlinkAddress now) {
        vehicles.values().forEach(known -> known.moved(before, now));
    }

    /** Which radios report themselves now. */
    public void radios(RadioSignals now) {
        radios = now;
        vehicles.values().forEach(known -> known.links().radios(now));
    }

    /** The radios that report themselves. */
    public RadioSignals radios() {
        return radios;
    }
}
