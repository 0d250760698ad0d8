package org.sami.domain.uav;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.sami.spn.value.GeoPoint;

/** A simulated aircraft that can stand in the air: it climbs, flies level, and comes down. Metres are taken on a flat earth. */
final class SimulatedUav {
    private static final double CLIMB_MPS = 3;
    private static final double M_PER_DEG = 111_195;

    private final GeoPoint home;
    private double latDeg;
    private double lonDeg;
    private double altitudeM;
    private double speedMps;
    private final Deque<GeoPoint> route = new ArrayDeque<>();
    private boolean underWay;

    SimulatedUav(double latDeg, double lonDeg) {
        this.latDeg = latDeg;
        this.lonDeg = lonDeg;
        this.home = position();
    }

    /** Where it is; the altitude is that above the ground that it took off from. */
    GeoPoint position() {
        return new GeoPoint(latDeg, lonDeg, altitudeM);
    }

    void flyTo(GeoPoint point, double newSpeedMps) {
        fly(List.of(point), newSpeedMps);
    }

    /** Flies around the place where it is and comes back to it. */
    void circle(double radiusM, double newSpeedMps) {
        double north = radiusM / M_PER_DEG;
        double east = north / Math.cos(Math.toRadians(latDeg));
        fly(
                List.of(
                        new GeoPoint(latDeg + north, lonDeg, altitudeM),
                        new GeoPoint(latDeg, lonDeg + east, altitudeM),
                        new GeoPoint(latDeg - north, lonDeg, altitudeM),
                        new GeoPoint(latDeg, lonDeg - east, altitudeM),
                        position()),
                newSpeedMps);
    }

    /** Flies back at its altitude and lands where it took off. */
    void returnHome(double newSpeedMps) {
        fly(List.of(new GeoPoint(home.latDeg(), home.lonDeg(), altitudeM), home), newSpeedMps);
    }

    void land() {
        flyTo(new GeoPoint(latDeg, lonDeg, 0), 0);
    }

    private void fly(List<GeoPoint> points, double newSpeedMps) {
        route.clear();
        route.addAll(points);
        speedMps = newSpeedMps;
        underWay = true;
    }

    /** Stands in the air where it is. */
    void hover() {
        route.clear();
        underWay = false;
    }

    boolean isThere() {
        return underWay && route.isEmpty();
    }

    /** How far a point is from the aircraft on the ground. */
    double distanceM(GeoPoint point) {
        double north = (point.latDeg() - latDeg) * M_PER_DEG;
        double east = (point.lonDeg() - lonDeg) * M_PER_DEG * Math.cos(Math.toRadians(latDeg));
        return Math.hypot(north, east);
    }

    /** Climbs or sinks first, then flies level. */
    void step(double seconds) {
        if (route.isEmpty()) {
            return;
        }
        GeoPoint to = route.peek();
        double climbM = to.altM() - altitudeM;
        if (climbM != 0) {
            altitudeM = Math.abs(climbM) <= CLIMB_MPS * seconds
                    ? to.altM()
                    : altitudeM + Math.signum(climbM) * CLIMB_MPS * seconds;
        } else {
            double left = distanceM(to);
            double part = left <= speedMps * seconds ? 1 : speedMps * seconds / left;
            latDeg = part == 1 ? to.latDeg() : latDeg + part * (to.latDeg() - latDeg);
            lonDeg = part == 1 ? to.lonDeg() : lonDeg + part * (to.lonDeg() - lonDeg);
        }
        if (position().equals(to)) {
            route.remove();
        }
    }
}
