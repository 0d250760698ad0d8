package org.sami.boat.hull.position;

import org.sami.boat.server.vehicle.PlaneMath;

/** Compares the compass with the course over ground while the hull drives ahead: their mean difference over the last seconds. */
final class CourseCheck {
    private static final double LEAST_SPEED_MPS = 0.7;
    private static final double LEAST_THRUST = 0.05;
    private static final double CURRENT_MPS = 0.25; // turns the course off the heading
    private static final double WAVES_RAD = Math.toRadians(8);
    private static final double MEAN_MS = 5000;
    private static final long CERTAIN_MS = 8000;
    private static final double DISAGREES_RAD = Math.toRadians(40);
    private static final double AGREES_RAD = Math.toRadians(25);

    private double shownRad = Double.NaN;
    private double sin;
    private double cos;
    private double comparedMs;
    private long lastMs = Long.MIN_VALUE;
    private boolean disagrees;

    /** The compass shows a heading from true north. */
    void compass(double headingRad) {
        shownRad = headingRad;
    }

    /** Whether the course of a hull says where its bow points: it drives ahead, by its motors if they are known. */
    boolean isHeading(double speedMps, double thrust) {
        return speedMps >= LEAST_SPEED_MPS && !(thrust < LEAST_THRUST);
    }

    /** Standard deviation of a heading by the course. */
    static double errorRad(double speedMps) {
        return Math.hypot(WAVES_RAD, StrictMath.asin(Math.min(1, CURRENT_MPS / speedMps)));
    }

    /** The hull moves on a course; whether it has become clear just now that the compass disagrees. */
    boolean course(double speedMps, double courseRad, double thrust, long nowMs) {
        double ms = lastMs == Long.MIN_VALUE ? 0 : Math.min(1000, nowMs - lastMs);
        lastMs = nowMs;
        if (!isHeading(speedMps, thrust) || Double.isNaN(shownRad)) {
            return false;
        }
        double part = Math.min(1, ms / MEAN_MS);
        double off = shownRad - courseRad;
        sin += part * (Math.sin(off) - sin);
        cos += part * (Math.cos(off) - cos);
        comparedMs = Math.min(2 * CERTAIN_MS, comparedMs + ms);
        double meanRad = Math.abs(StrictMath.atan2(sin, cos));
        boolean before = disagrees;
        disagrees = comparedMs >= CERTAIN_MS && meanRad > (before ? AGREES_RAD : DISAGREES_RAD);
        return disagrees && !before;
    }

    boolean disagrees() {
        return disagrees;
    }

    double disagreementRad() {
        return comparedMs == 0 ? Double.NaN : PlaneMath.sameTurn(StrictMath.atan2(sin, cos));
    }
}
