package org.sami.boat.server.traffic;

import java.util.Optional;

/**
 * Keeps a boat out of the way of vessels that are not of its base. They give way to nobody and do not stop, so a boat steps aside in time out of the strip of
 * water that such a vessel sweeps if it goes straight on, and does not enter that strip shortly before it. Positions are in metres on the plane of {@link
 * Surroundings}.
 */
final class VesselsInMotion {
    /** A slower vessel is an obstacle like a boat that lies still. */
    private static final double LEAST_MPS = 0.2;

    /** A boat needs so long to turn, in seconds, before it makes headway aside. */
    private static final double TURNING_S = 6;

    /** Vessels are looked at so long ahead, in seconds. */
    private static final double LOOKAHEAD_S = 40;

    /** Share of its speed that a boat keeps while it steps aside. */
    private static final double SPEED_SHARE = 0.8;

    /** A boat that waits does so this far outside the strip, in metres. */
    private static final double WAITS_OUTSIDE_M = 2;

    private static final double LEAST_OWN_MPS = 0.8;

    private final Surroundings surroundings;

    VesselsInMotion(Surroundings surroundings) {
        this.surroundings = surroundings;
    }

    /**
     * The way aside, or a way of no length where the boat has to wait; empty where it need not care.
     *
     * @param course that the boat intends
     * @param courseMps how fast it intends to be
     * @param stopsM its stopping distance in metres
     * @param keepM the distance to keep from a vessel's circle, in metres
     */
    Optional<LineAhead> way(
            double eastM,
            double northM,
            CourseVector course,
            double courseMps,
            double stopsM,
            double keepM,
            long nowMs) {
        for (OtherBoat vessel : surroundings.others()) {
            if (vessel.radiusM() > 0 && vessel.speedMps() >= LEAST_MPS) {
                Optional<LineAhead> way = way(vessel, eastM, northM, course, courseMps, stopsM, keepM, nowMs);
                if (way.isPresent()) {
                    return way;
                }
            }
        }
        return Optional.empty();
    }

    private static Optional<LineAhead> way(
            OtherBoat vessel,
            double eastM,
            double northM,
            CourseVector course,
            double courseMps,
            double stopsM,
            double keepM,
            long nowMs) {
        double halfM = vessel.radiusM() + keepM; // of the strip
        double byEastM = eastM - vessel.eastM(nowMs);
        double byNorthM = northM - vessel.northM(nowMs);
        double aheadM = byEastM * vessel.aheadEast() + byNorthM * vessel.aheadNorth();
        double starboardM = byEastM * vessel.aheadNorth() - byNorthM * vessel.aheadEast();
        double arrivesS = (aheadM - halfM) / vessel.speedMps();
        if (aheadM < -halfM || arrivesS > LOOKAHEAD_S) {
            return Optional.empty(); // it has passed, or is far away
        }
        double ownMps = SPEED_SHARE * Math.max(LEAST_OWN_MPS, courseMps);
        double side = starboardM < 0 ? -1 : 1;
        double missingM = halfM - Math.abs(starboardM);
        if (missingM > 0) {
            double neededS = missingM / ownMps + TURNING_S;
            // at that time the boat is aside of the vessel's course, to starboard or to port
            return arrivesS > neededS
                    ? Optional.empty()
                    : Optional.of(LineAhead.straight(
                            StrictMath.atan2(side * vessel.aheadNorth(), -side * vessel.aheadEast()), missingM));
        }
        double towardsMps =
                -side * courseMps * (course.east() * vessel.aheadNorth() - course.north() * vessel.aheadEast());
        boolean enters = towardsMps > 0 && -missingM < stopsM + WAITS_OUTSIDE_M;
        if (!enters) {
            return Optional.empty();
        }
        double crossesS = (2 * halfM - missingM) / Math.max(0.1, SPEED_SHARE * towardsMps);
        double alongMps = courseMps * (course.east() * vessel.aheadEast() + course.north() * vessel.aheadNorth());
        double leavesAheadM = aheadM + alongMps * crossesS - vessel.speedMps() * crossesS; // when the boat is across
        boolean crossesBefore = leavesAheadM > halfM && arrivesS > 0;
        return crossesBefore ? Optional.empty() : Optional.of(LineAhead.straight(course.rad(), 0));
    }
}
