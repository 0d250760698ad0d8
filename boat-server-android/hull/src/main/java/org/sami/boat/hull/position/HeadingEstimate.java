package org.sami.boat.hull.position;

import org.sami.boat.server.vehicle.PlaneMath;

/**
 * Heading and error of the compass: a Kalman filter of two states. The turn rate is the gyro's, or what the motors should make of the hull; the compass
 * measures heading and its own error together, the course over ground the heading alone.
 */
final class HeadingEstimate {
    private static final double COMPASS_ERROR = Math.toRadians(6);
    private static final double FIRST_OFFSET = Math.toRadians(12); // of a compass in a box with motors
    private static final double OFFSET_WALK = Math.toRadians(0.3); // in a second
    private static final double GYRO_WALK = Math.toRadians(1.5); // in a second
    private static final double MOTOR_WALK = Math.toRadians(20); // in a second: wind and waves turn the hull as well
    private static final double UNKNOWN = Math.PI;

    private double headingRad;
    private double offsetRad;
    private double headingVar = UNKNOWN * UNKNOWN;
    private double offsetVar = FIRST_OFFSET * FIRST_OFFSET;
    private double covariance;
    private boolean known;

    /** Whether the heading was measured, or assumed, once. */
    boolean isKnown() {
        return known;
    }

    double headingRad() {
        return headingRad;
    }

    double errorRad() {
        return Math.min(UNKNOWN, Math.sqrt(headingVar));
    }

    /** Assumes north where nothing measures the heading yet. */
    void assumeNorth() {
        known = true;
    }

    /** Lets time pass while the hull turns at a rate, to starboard. */
    void turn(double rateRadPerS, boolean measured, double seconds) {
        headingRad = PlaneMath.sameTurn(headingRad + rateRadPerS * seconds);
        double walk = measured ? GYRO_WALK : MOTOR_WALK;
        headingVar = Math.min(UNKNOWN * UNKNOWN, headingVar + walk * walk * seconds);
        offsetVar += OFFSET_WALK * OFFSET_WALK * seconds;
    }

    /** The compass shows a heading from true north. */
    void compass(double shownRad) {
        if (!known) {
            known = true;
            headingRad = PlaneMath.sameTurn(shownRad);
            headingVar = offsetVar + COMPASS_ERROR * COMPASS_ERROR;
            covariance = -offsetVar;
            return;
        }
        double innovation = PlaneMath.sameTurn(shownRad - headingRad - offsetRad);
        double var = headingVar + 2 * covariance + offsetVar + COMPASS_ERROR * COMPASS_ERROR;
        correct(innovation, (headingVar + covariance) / var, (covariance + offsetVar) / var, var);
    }

    /** The course over ground shows the heading of a hull that drives ahead. */
    void course(double courseRad, double errorRad) {
        if (!known) {
            known = true;
            headingRad = PlaneMath.sameTurn(courseRad);
            headingVar = errorRad * errorRad;
            return;
        }
        double innovation = PlaneMath.sameTurn(courseRad - headingRad);
        double var = headingVar + errorRad * errorRad;
        correct(innovation, headingVar / var, covariance / var, var);
    }

    /** The compass is wrong by more than usual: its error is open again. */
    void doubtCompass() {
        double open = Math.toRadians(60);
        offsetVar = Math.max(offsetVar, open * open);
        headingVar = Math.max(headingVar, open * open);
        covariance = 0;
    }

    private void correct(double innovation, double headingGain, double offsetGain, double var) {
        headingRad = PlaneMath.sameTurn(headingRad + headingGain * innovation);
        offsetRad = PlaneMath.sameTurn(offsetRad + offsetGain * innovation);
        covariance -= headingGain * offsetGain * var;
        headingVar = Math.max(1e-6, headingVar - headingGain * headingGain * var);
        offsetVar = Math.max(1e-6, offsetVar - offsetGain * offsetGain * var);
        double most = Math.sqrt(headingVar * offsetVar);
        covariance = Math.max(-most, Math.min(most, covariance));
    }
}
