package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.common.CameraTrackingGeoStatus;
import io.dronefleet.mavlink.common.CameraTrackingStatusFlags;
import java.util.Optional;

/** Reads where the target is that a camera follows. */
final class TrackedTargets {
    private static final double DEGREES = 1e-7; // of a position's whole numbers
    private static final double MAX_LAT = 90;
    private static final double MAX_LON = 180;

    private TrackedTargets() {}

    /** What a camera of a vehicle says of its target; empty where it follows none, or does not know where it is (0, 0 and what is no place). */
    static Optional<VehicleEvent> of(VehicleId vehicle, CameraTrackingGeoStatus target) {
        double lat = target.lat() * DEGREES;
        double lon = target.lon() * DEGREES;
        boolean isPlace =
                (target.lat() != 0 || target.lon() != 0) && Math.abs(lat) <= MAX_LAT && Math.abs(lon) <= MAX_LON;
        return isPlace
                        && target.trackingStatus().entry()
                                == CameraTrackingStatusFlags.CAMERA_TRACKING_STATUS_FLAGS_ACTIVE
                ? Optional.of(new VehicleEvent.TargetTracked(vehicle, lat, lon))
                : Optional.empty();
    }
}
