package org.sami.crw.service.water;

/**
 * How far a boat may truly be off the straight line that it follows. Planners derive from it how far paths keep off no-go areas ({@link SafetyMargin};
 * docs/services.md).
 *
 * @param steeringM distance from the line in still water with exact instruments, also at corners, in metres: the least distance of any path from
 *     forbidden areas
 * @param positionM standard deviation of the position that the boat knows, along each axis, in metres
 * @param driftMps speed at which current and wind carry a boat that does not steer against them, in m/s
 */
public record CrossTrackError(double steeringM, double positionM, double driftMps) {
    /** What the boat server's navigator keeps in still water; measured up to 0.4 m at 1.5 and at 3 m/s. */
    private static final double STEERING_M = 0.6;

    /** A boat that turns at a corner drifts for so long until it steers against it. */
    static final double TURN_S = 4;

    private static final double MOST_DEVIATIONS = 5; // exceeded once in some years

    /** No error at all: for geometry alone. */
    public static final CrossTrackError NONE = new CrossTrackError(0, 0, 0);

    /** Still water, exact instruments. */
    public static final CrossTrackError CALM = of(0, 0);

    /**
     * A lake on an ordinary day. Positions wander by 1.4 m along each axis, as in a log of 2016 within a minute, and jump by up to 2.1 m.
     * There is a current of 0.15 m/s, and a wind of 3 m/s that carries a hull at 3 % of its speed.
     */
    public static final CrossTrackError FIELD = of(Math.hypot(1.4, 2.1 / 3), 0.15 + 0.03 * 3);

    public CrossTrackError {
        if (!(steeringM >= 0 && positionM >= 0 && driftMps >= 0 && Double.isFinite(steeringM + positionM + driftMps))) {
            throw new IllegalArgumentException(
                    "a cross-track error of " + steeringM + " m, " + positionM + " m and " + driftMps + " m/s");
        }
    }

    /** The error of boats with this deviation of the position, in metres, and this drift, in m/s. */
    public static CrossTrackError of(double positionM, double driftMps) {
        return new CrossTrackError(STEERING_M, positionM, driftMps);
    }

    /** The same of a boat with a turning circle, which leaves its path in corners by the radius of its narrowest turn, in metres. */
    public CrossTrackError turning(double radiusM) {
        return radiusM > steeringM ? new CrossTrackError(radiusM, positionM, driftMps) : this;
    }

    /** The larger of this and another, each part by itself. */
    public CrossTrackError atLeast(CrossTrackError other) {
        return new CrossTrackError(
                Math.max(steeringM, other.steeringM),
                Math.max(positionM, other.positionM),
                Math.max(driftMps, other.driftMps));
    }

    /** The largest cross-track error assumed of a boat, in metres. */
    public double mostM() {
        return steeringM + MOST_DEVIATIONS * positionM + 2 * TURN_S * driftMps;
    }
}
