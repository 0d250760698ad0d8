package org.sami.boat.server;

import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * How fast a vehicle may pass a waypoint so that it keeps to the legs that follow: slowly where it turns much, and where soon after it a
 * sharper turn or the end of the track comes, for which it has to slow down.
 */
final class CornerSpeed {
    /** How fast small hulls slow down with motors at rest, in m/s per second. */
    static final double BRAKING_MPS2 = 0.35;

    /** Across the next leg: while it turns, a boat is carried on so fast. */
    private static final double ASIDE_MPS = 0.25;

    private static final double MOST_MPS = 12.5;
    private static final double SEEN_M = 30; // from 4.6 m/s to rest
    private static final int SEEN = 50; // waypoints: where more are so near, it goes slowly anyway

    private CornerSpeed() {}

    /**
     * The speed at the target of a track.
     *
     * @param end a frame at the target
     * @param fromEastM where the leg to the target begins
     * @param fromNorthM where the leg to the target begins
     */
    static double atTarget(WaypointTrack track, LocalFrame end, double fromEastM, double fromNorthM) {
        return at(track, 0, end, -fromEastM, -fromNorthM, 0, 0, 0);
    }

    /** The speed at a waypoint after so many others, which lies here, when it is come to in this direction. */
    private static double at(
            WaypointTrack track,
            int ahead,
            LocalFrame frame,
            double alongEastM,
            double alongNorthM,
            double eastM,
            double northM,
            double seenM) {
        if (!track.hasAfterTarget(ahead + 1) || ahead == SEEN) {
            return ASIDE_MPS;
        }
        Waypoint next = track.afterTarget(ahead + 1);
        double nextEastM = frame.eastM(next.latDeg(), next.lonDeg());
        double nextNorthM = frame.northM(next.latDeg(), next.lonDeg());
        double legEastM = nextEastM - eastM;
        double legNorthM = nextNorthM - northM;
        double legM = PlaneMath.length(legEastM, legNorthM);
        double turningMps = turning(alongEastM, alongNorthM, legEastM, legNorthM);
        if (seenM + legM > SEEN_M) {
            return turningMps;
        }
        double thenMps = at(track, ahead + 1, frame, legEastM, legNorthM, nextEastM, nextNorthM, seenM + legM);
        return Math.min(turningMps, Math.sqrt(thenMps * thenMps + 2 * BRAKING_MPS2 * legM));
    }

    /** The speed whose part across the next leg is small; that of a turn back where a leg has no direction. */
    private static double turning(double eastM, double northM, double nextEastM, double nextNorthM) {
        double ahead = eastM * nextEastM + northM * nextNorthM;
        double aside = Math.abs(eastM * nextNorthM - northM * nextEastM);
        double sine = aside / (PlaneMath.length(eastM, northM) * PlaneMath.length(nextEastM, nextNorthM));
        return ahead > 0 ? Math.min(MOST_MPS, ASIDE_MPS / sine) : ASIDE_MPS;
    }
}
