package org.sami.boat.server.traffic;

import org.sami.boat.link.BoatMode;
import org.sami.boat.link.NearbyBoat;
import org.sami.boat.server.vehicle.LocalFrame;

/** Another boat as last reported, in metres on the plane of {@link Surroundings}. It is assumed to hold its course and speed. For one thread. */
final class OtherBoat {
    private static final double SLOW_MPS = 0.3;
    private static final long PREDICTED_MS = 1500; // it is assumed to go straight on for no longer

    private final String boatId;
    private BoatMode mode = BoatMode.STOPPED;
    private double radiusM;
    private double eastM;
    private double northM;
    private double speedMps;
    private double aheadEast; // unit vector of its heading
    private double aheadNorth;
    private double stopsM; // stopping distance along it; negative astern
    private double eastMps;
    private double northMps;
    private long seenMs;
    private double toEastM;
    private double toNorthM;

    /** A boat without a report yet. */
    OtherBoat(String boatId) {
        this.boatId = boatId;
        seenMs = Long.MIN_VALUE;
    }

    /**
     * Takes a newer report.
     *
     * @param ofRadiusM of the circle that others keep from; 0 for a boat of the fleet
     * @param plane the plane of {@code atEastM} and {@code atNorthM}
     */
    void update(NearbyBoat row, double ofRadiusM, double atEastM, double atNorthM, LocalFrame plane, long atMs) {
        mode = row.mode();
        radiusM = ofRadiusM;
        eastM = atEastM;
        northM = atNorthM;
        speedMps = row.speedMps();
        aheadEast = row.headingEast();
        aheadNorth = row.headingNorth();
        eastMps = speedMps * aheadEast;
        northMps = speedMps * aheadNorth;
        stopsM = Stopping.distanceM(speedMps, Stopping.REACTION_S);
        seenMs = atMs;
        toEastM = row.isGoing() ? plane.eastM(row.toLatDeg(), row.toLonDeg()) : Double.NaN;
        toNorthM = row.isGoing() ? plane.northM(row.toLatDeg(), row.toLonDeg()) : Double.NaN;
    }

    String boatId() {
        return boatId;
    }

    long seenMs() {
        return seenMs;
    }

    double eastM(long nowMs) {
        return eastAfterM(sinceS(nowMs));
    }

    double northM(long nowMs) {
        return northAfterM(sinceS(nowMs));
    }

    /** Predicted position, {@code seconds} after the report. */
    double eastAfterM(double seconds) {
        return eastM + eastMps * seconds;
    }

    /** Predicted position, {@code seconds} after the report. */
    double northAfterM(double seconds) {
        return northM + northMps * seconds;
    }

    /** How long the boat has moved on since its report, in seconds; limited to how long it is predicted. */
    double sinceS(long nowMs) {
        return Math.max(0, Math.min(PREDICTED_MS, nowMs - seenMs)) / 1000.0;
    }

    double eastMps() {
        return eastMps;
    }

    double northMps() {
        return northMps;
    }

    /** Of the circle around it that others keep from, in metres; 0 for a boat of the fleet. */
    double radiusM() {
        return radiusM;
    }

    double speedMps() {
        return speedMps;
    }

    /** Unit vector of its heading, to the east. */
    double aheadEast() {
        return aheadEast;
    }

    /** Unit vector of its heading, to the north. */
    double aheadNorth() {
        return aheadNorth;
    }

    /** Its course in radians; for a boat that waits and whose point is known, the course to that point. */
    double courseRad(long nowMs) {
        return isSlow() && isGoing()
                ? StrictMath.atan2(toEastM - eastM(nowMs), toNorthM - northM(nowMs))
                : StrictMath.atan2(aheadEast, aheadNorth);
    }

    /** Stopping distance in metres. */
    double stopsWithinM() {
        return Math.abs(stopsM);
    }

    /** Its stopping segment from a position. */
    Segment stoppingAt(double atEastM, double atNorthM) {
        return Segment.along(atEastM, atNorthM, stopsM, aheadEast, aheadNorth);
    }

    /** Whether it follows a path by itself, and so gives way as this boat does. */
    boolean isUnderWay() {
        return mode == BoatMode.PATH || mode == BoatMode.RETURN;
    }

    /** Whether it lies still or nearly so. */
    boolean isSlow() {
        return Math.abs(speedMps) < SLOW_MPS;
    }

    /** Whether it is under way to a known point. */
    boolean isGoing() {
        return isUnderWay() && !Double.isNaN(toEastM);
    }

    double toEastM() {
        return toEastM;
    }

    double toNorthM() {
        return toNorthM;
    }
}
