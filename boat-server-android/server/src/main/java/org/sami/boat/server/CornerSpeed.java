package org.sami.boat.server;

import org.sami.boat.link.MotionDefaults;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * The speed at which a vehicle may pass a waypoint and still follow the next legs. It is low at a sharp turn, and before a sharper turn or the end of the
 * track close behind the waypoint.
 */
final class CornerSpeed {
    static final double BRAKING_MPS2 = MotionDefaults.BRAKING_MPS2;

    /** Speed across the next leg at which a turning boat may drift, in m/s. */
    private static final double TURN_DRIFT_MPS = 0.25;

    private static final double MOST_MPS = 12.5;
    private static final double LOOKAHEAD_M = 30; // from 4.6 m/s to rest
    private static final int LOOKAHEAD = 50; // waypoints: where more are that near, the boat is slow anyway

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

    /** The speed at the waypoint {@code ahead} places after the target, at a position and approached in a direction. */
    private static double at(
            WaypointTrack track,
            int ahead,
            LocalFrame frame,
            double alongEastM,
            double alongNorthM,
            double eastM,
            double northM,
            double seenM) {
        if (!track.hasAfterTarget(ahead + 1) || ahead == LOOKAHEAD) {
            return TURN_DRIFT_MPS;
        }
        Waypoint next = track.afterTarget(ahead + 1);
        double nextEastM = frame.eastM(next.latDeg(), next.lonDeg());
        double nextNorthM = frame.northM(next.latDeg(), next.lonDeg());
        double legEastM = nextEastM - eastM;
        double legNorthM = nextNorthM - northM;
        double legM = PlaneMath.length(legEastM, legNorthM);
        double turningMps = turning(alongEastM, alongNorthM, legEastM, legNorthM);
        if (seenM + legM > LOOKAHEAD_M) {
            return turningMps;
        }
        double thenMps = at(track, ahead + 1, frame, legEastM, legNorthM, nextEastM, nextNorthM, seenM + legM);
        return Math.min(turningMps, Math.sqrt(thenMps * thenMps + 2 * BRAKING_MPS2 * legM));
    }

    /** The speed whose share across the next leg is small; that of a turn back where a leg has no direction. */
    private static double turning(double eastM, double northM, double nextEastM, double nextNorthM) {
        double ahead = eastM * nextEastM + northM * nextNorthM;
        double aside = Math.abs(eastM * nextNorthM - northM * nextEastM);
        double sine = aside / (PlaneMath.length(eastM, northM) * PlaneMath.length(nextEastM, nextNorthM));
        return ahead > 0 ? Math.min(MOST_MPS, TURN_DRIFT_MPS / sine) : TURN_DRIFT_MPS;
    }
}
