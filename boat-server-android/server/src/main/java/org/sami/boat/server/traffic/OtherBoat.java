package org.sami.boat.server.traffic;

import org.sami.boat.link.BoatMode;
import org.sami.boat.link.NearbyBoat;
import org.sami.boat.server.vehicle.LocalFrame;

/** Another boat as it was seen last, in metres of the plane of {@link Surroundings}. It is taken to go on as it did. For one thread. */
final class OtherBoat {
    private static final double SLOW_MPS = 0.3;
    private static final long FORETOLD_MS = 1500; // for longer it is not taken to go straight on

    private final String boatId;
    private BoatMode mode;
    private double eastM;
    private double northM;
    private double speedMps;
    private double aheadEast; // unit vector of its heading
    private double aheadNorth;
    private double stopsM; // along it, if it begins to stop now
    private double eastMps;
    private double northMps;
    private long seenMs;
    private double toEastM;
    private double toNorthM;

    /** A boat that nobody has seen yet. */
    OtherBoat(String boatId) {
        this.boatId = boatId;
        seenMs = Long.MIN_VALUE;
    }

    /**
     * Takes up where it was seen, which is later than before.
     *
     * @param plane on which that is so many metres east and north of the origin
     */
    void update(NearbyBoat row, double atEastM, double atNorthM, LocalFrame plane, long atMs) {
        mode = row.mode();
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

    /** Where it is so many seconds after it was seen. */
    double eastAfterM(double seconds) {
        return eastM + eastMps * seconds;
    }

    /** Where it is so many seconds after it was seen. */
    double northAfterM(double seconds) {
        return northM + northMps * seconds;
    }

    /** For how long it goes on as it was seen, in seconds. */
    double sinceS(long nowMs) {
        return Math.max(0, Math.min(FORETOLD_MS, nowMs - seenMs)) / 1000.0;
    }

    double eastMps() {
        return eastMps;
    }

    double northMps() {
        return northMps;
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

    /** The course on which it goes, or will once it can, in radians: that to its point, where it waits and the point is known. */
    double courseRad(long nowMs) {
        return isSlow() && isGoing()
                ? StrictMath.atan2(toEastM - eastM(nowMs), toNorthM - northM(nowMs))
                : StrictMath.atan2(aheadEast, aheadNorth);
    }

    /** How far it goes until it has stopped, in metres. */
    double stopsWithinM() {
        return Math.abs(stopsM);
    }

    /** The way on which it stops, if it is at a place. */
    Segment stoppingAt(double atEastM, double atNorthM) {
        return Segment.along(atEastM, atNorthM, stopsM, aheadEast, aheadNorth);
    }

    /** Whether it follows its way by itself, so that it gives way as this boat does. */
    boolean isUnderWay() {
        return mode == BoatMode.PATH || mode == BoatMode.RETURN;
    }

    /** Whether it lies still, or nearly so, and is not soon out of anybody's way. */
    boolean isSlow() {
        return Math.abs(speedMps) < SLOW_MPS;
    }

    /** Whether it is under way to a point that is known. */
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
