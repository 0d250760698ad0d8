package org.sami.crw.mavlink;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Motion;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.Telemetry;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleReading;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** What a vehicle reports, as boats say it. */
final class VehicleReports {
    private static final double MOST_MPS = 50; // what a message of the link carries, and faster than any boat
    private static final String SENSOR = "autopilot";

    private VehicleReports() {}

    /**
     * Where it is and how it moves; none as long as it says no position that can be trusted.
     *
     * @param percent its charge
     * @param givesWayTo the boat to which it gives way; empty text for none
     */
    static Optional<Telemetry> telemetry(
            VehicleSnapshot vehicle, double percent, BoatMode mode, String givesWayTo, long nowMs) {
        return place(vehicle)
                .map(at -> new Telemetry(
                        at.latDeg(),
                        at.lonDeg(),
                        Math.toRadians(at.headingDeg().orElse(0.0)),
                        at.speedMps(),
                        percent,
                        mode,
                        nowMs,
                        altitude(vehicle, at),
                        givesWayTo));
    }

    /** Its altitude in metres over where it was armed, 0 on the ground; none of what does not fly. */
    private static OptionalDouble altitude(VehicleSnapshot vehicle, VehiclePosition at) {
        if (vehicle.kind() != VehicleKind.COPTER) {
            return OptionalDouble.empty();
        }
        return OptionalDouble.of(vehicle.armed() ? Math.max(0, at.heightM()) : 0);
    }

    /** How it moves, for the boats near it; none as long as it says no position that can be trusted. */
    static Optional<Motion> motion(VehicleSnapshot vehicle, BoatMode mode) {
        return place(vehicle)
                .map(at -> new Motion(
                        at.latDeg(), at.lonDeg(), Math.toRadians(at.headingDeg().orElse(0.0)), at.speedMps(), mode));
    }

    /** Where it is; none where its filter does not trust it, or where it says a speed that no boat has. */
    private static Optional<VehiclePosition> place(VehicleSnapshot vehicle) {
        return vehicle.position().filter(at -> vehicle.located() && at.speedMps() <= MOST_MPS);
    }

    /** A value of a sensor, where the vehicle is now. */
    static Optional<SensorReport> reading(VehicleSnapshot vehicle, VehicleReading reading, long nowMs) {
        String channel = reading.name().strip().toLowerCase(Locale.ROOT);
        return place(vehicle)
                .filter(at -> !channel.isEmpty())
                .map(at -> new SensorReport(
                        SENSOR,
                        channel,
                        java.util.List.of(reading.value()),
                        reading.unit(),
                        at.latDeg(),
                        at.lonDeg(),
                        nowMs));
    }

    /** The number of a picture, where it was taken. */
    static SensorReport picture(VehicleEvent.PictureTaken picture, long nowMs) {
        return new SensorReport(
                "camera",
                "picture",
                java.util.List.of((double) picture.number()),
                "",
                picture.latDeg(),
                picture.lonDeg(),
                nowMs);
    }
}
