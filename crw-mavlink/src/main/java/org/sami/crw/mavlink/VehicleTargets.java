package org.sami.crw.mavlink;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.sami.boat.link.SensorReport;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;
import org.sami.spn.value.GeoPoint;

/** The targets that a vehicle's camera follows, as the detectors of simulated copters report theirs: each at most once a second. For the gateway's thread. */
final class VehicleTargets {
    private static final String SENSOR = "camera";
    private static final String CHANNEL = "target";
    private static final long PERIOD_MS = 1_000;

    private final SeenTargets seen;
    private final Map<Integer, Long> saidMs = new HashMap<>(); // by number

    /**
     * None yet.
     *
     * @param seen numbers them, together with those of the other vehicles
     */
    VehicleTargets(SeenTargets seen) {
        this.seen = seen;
    }

    /** What is to be said: the target's number, latitude and longitude, with the vehicle's own place; empty where that was said within the second. */
    Optional<SensorReport> report(VehicleSnapshot vehicle, VehicleEvent.TargetTracked target, long nowMs) {
        OptionalInt number = seen.number(GeoPoint.of(target.latDeg(), target.lonDeg()));
        if (number.isEmpty() || nowMs - saidMs.getOrDefault(number.getAsInt(), Long.MIN_VALUE / 2) < PERIOD_MS) {
            return Optional.empty();
        }
        saidMs.put(number.getAsInt(), nowMs);
        return Optional.of(new SensorReport(
                SENSOR,
                CHANNEL,
                List.of((double) number.getAsInt(), target.latDeg(), target.lonDeg()),
                "",
                vehicle.position().map(VehiclePosition::latDeg).orElse(target.latDeg()),
                vehicle.position().map(VehiclePosition::lonDeg).orElse(target.lonDeg()),
                Math.max(0, nowMs)));
    }
}
