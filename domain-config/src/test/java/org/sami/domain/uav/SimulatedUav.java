package org.sami.domain.uav;

import java.util.Optional;
import org.sami.spn.value.GeoPoint;

/** A simulated aircraft that can stand in the air: it climbs, flies level, and comes down. Metres are taken on a flat earth. */
final class SimulatedUav {
    private static final double CLIMB_MPS = 3;
    private static final double M_PER_DEG = 111_195;

    private double latDeg;
    private double lonDeg;
    private double altitudeM;
    private double speedMps;
    private Optional<GeoPoint> target = Optional.empty();

    SimulatedUav(double latDeg, double lonDeg) {
        this.latDeg = latDeg;
        this.lonDeg = lonDeg;
    }

    /** Where it is; the altitude is that above the ground that it took off from. */
    GeoPoint position() {
        return new GeoPoint(latDeg, lonDeg, altitudeM);
    }

    void flyTo(GeoPoint point, double newSpeedMps) {
        target = Optional.of(point);
        speedMps = newSpeedMps;
    }

    void land() {
        flyTo(new GeoPoint(latDeg, lonDeg, 0), 0);
    }

    /** Stands in the air where it is. */
    void hover() {
        target = Optional.empty();
    }

    boolean isThere() {
        return target.isPresent() && position().equals(target.get());
    }

    /** Climbs or sinks first, then flies level. */
    void step(double seconds) {
        if (target.isEmpty()) {
            return;
        }
        GeoPoint to = target.get();
        double climbM = to.altM() - altitudeM;
        if (climbM != 0) {
            altitudeM = Math.abs(climbM) <= CLIMB_MPS * seconds
                    ? to.altM()
                    : altitudeM + Math.signum(climbM) * CLIMB_MPS * seconds;
            return;
        }
        double north = (to.latDeg() - latDeg) * M_PER_DEG;
        double east = (to.lonDeg() - lonDeg) * M_PER_DEG * Math.cos(Math.toRadians(latDeg));
        double left = Math.hypot(north, east);
        double part = left <= speedMps * seconds ? 1 : speedMps * seconds / left;
        latDeg = part == 1 ? to.latDeg() : latDeg + part * (to.latDeg() - latDeg);
        lonDeg = part == 1 ? to.lonDeg() : lonDeg + part * (to.lonDeg() - lonDeg);
    }
}
