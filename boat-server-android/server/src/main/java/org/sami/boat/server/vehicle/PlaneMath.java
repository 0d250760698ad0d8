package org.sami.boat.server.vehicle;

/**
 * What every boat computes some hundred times a second on a plane in metres. Java's own functions for it guard against numbers that no water holds, at ten
 * times the cost.
 */
public final class PlaneMath {
    private static final double FULL_TURN_RAD = 2 * Math.PI;

    private PlaneMath() {}

    /** The length of a vector east and north, in its unit; its squares must fit a double, unlike with {@link Math#hypot}. */
    public static double length(double east, double north) {
        return Math.sqrt(east * east + north * north);
    }

    /** The same turn in -π to π. To the last bit that of {@link Math#IEEEremainder}: a difference of doubles of which one is up to twice the other is not rounded. */
    public static double sameTurn(double rad) {
        if (Math.abs(rad) <= Math.PI) {
            return rad;
        }
        double oneTurnLess = rad - Math.copySign(FULL_TURN_RAD, rad);
        return Math.abs(oneTurnLess) <= Math.PI ? oneTurnLess : Math.IEEEremainder(rad, FULL_TURN_RAD);
    }
}
