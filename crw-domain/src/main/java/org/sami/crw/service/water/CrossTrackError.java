package org.sami.crw.service.water;

/**
 * How far a boat may truly be beside the straight line that it is to follow. Planners keep paths off what is not to be entered by it
 * (docs/decisions, 0301).
 *
 * @param steeringM in still water with exact instruments, at corners too: what no path is ever planned nearer to what is forbidden
 * @param positionM standard deviation of the position that the boat knows, along each axis, in metres
 * @param driftMps how fast current and wind carry a boat that does not steer against them
 */
public record CrossTrackError(double steeringM, double positionM, double driftMps) {
    /** What the boat server's navigator keeps in still water; measured up to 0.4 m at 1.5 and at 3 m/s. */
    private static final double STEERING_M = 0.6;

    /** A boat that turns at a corner drifts for so long until it steers against it. */
    private static final double TURN_S = 4;

    /** Ways are planned on one plane, told in degrees, and measured on another. */
    private static final double ROUNDING_M = 0.01;

    private static final double KEPT_DEVIATIONS = 3; // once in some hours
    private static final double MOST_DEVIATIONS = 5; // once in some years

    /** Nothing is off: for geometry alone. */
    public static final CrossTrackError NONE = new CrossTrackError(0, 0, 0);

    /** Still water, exact instruments. */
    public static final CrossTrackError CALM = of(0, 0);

    /**
     * A lake on an ordinary day: positions as in logs of the boats of 2013 to 2015, which wander by 1.4 m along each axis and jump by up to 2.1 m, a current of
     * 0.15 m/s, and a wind of 3 m/s that carries a hull with 3 % of its speed.
     */
    public static final CrossTrackError FIELD = of(Math.hypot(1.4, 2.1 / 3), 0.15 + 0.03 * 3);

    public CrossTrackError {
        if (!(steeringM >= 0 && positionM >= 0 && driftMps >= 0 && Double.isFinite(steeringM + positionM + driftMps))) {
            throw new IllegalArgumentException(
                    "a cross-track error of " + steeringM + " m, " + positionM + " m and " + driftMps + " m/s");
        }
    }

    /** That of boats whose position errs so much, and which drift so fast. */
    public static CrossTrackError of(double positionM, double driftMps) {
        return new CrossTrackError(STEERING_M, positionM, driftMps);
    }

    /** What neither this nor another exceeds. */
    public CrossTrackError atLeast(CrossTrackError other) {
        return new CrossTrackError(
                Math.max(steeringM, other.steeringM),
                Math.max(positionM, other.positionM),
                Math.max(driftMps, other.driftMps));
    }

    /** What paths keep from what is forbidden where there is room, in metres. */
    public double marginM() {
        return steeringM + KEPT_DEVIATIONS * positionM + TURN_S * driftMps;
    }

    /** What a boat is never farther beside its path, as far as can be told, in metres. */
    public double mostM() {
        return steeringM + MOST_DEVIATIONS * positionM + 2 * TURN_S * driftMps;
    }

    /** How far a boat may come into what its path passes at a distance, in metres; zero where it may not. */
    public double insideM(double clearanceM) {
        double insideM = mostM() - clearanceM;
        return insideM > ROUNDING_M ? insideM : 0;
    }
}
