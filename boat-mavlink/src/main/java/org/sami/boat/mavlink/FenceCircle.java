package org.sami.boat.mavlink;

import java.util.function.DoubleConsumer;
import org.sami.boat.server.vehicle.LocalFrame;

/** A circle of a fence. Immutable. */
final class FenceCircle implements FenceShape {
    private static final double STEP_DEG = 0.001; // over which a degree's length is measured

    private final Position centre;
    private final double radiusM;
    private final double eastM; // of a degree
    private final double northM;

    /**
     * A circle.
     *
     * @param centre at most 85 degrees from the equator
     */
    FenceCircle(Position centre, double radiusM) {
        this.centre = centre;
        this.radiusM = radiusM;
        LocalFrame frame = new LocalFrame(centre.latDeg(), centre.lonDeg());
        eastM = frame.eastM(centre.latDeg(), centre.lonDeg() + STEP_DEG) / STEP_DEG;
        northM = frame.northM(centre.latDeg() + STEP_DEG, centre.lonDeg()) / STEP_DEG;
    }

    @Override
    public boolean contains(Position at) {
        return Math.hypot(at.eastDeg(centre) * eastM, at.northDeg(centre) * northM) <= radiusM;
    }

    @Override
    public void crossings(Position from, Position to, DoubleConsumer fractions) {
        double x = from.eastDeg(centre) * eastM;
        double y = from.northDeg(centre) * northM;
        double dx = to.eastDeg(from) * eastM;
        double dy = to.northDeg(from) * northM;
        double square = dx * dx + dy * dy;
        double nearest = -(x * dx + y * dy) / square; // fraction at which the way is nearest to the centre
        double half = Math.sqrt(nearest * nearest - (x * x + y * y - radiusM * radiusM) / square);
        for (double fraction : new double[] {nearest - half, nearest + half}) {
            if (fraction >= 0 && fraction <= 1) { // not a number where the way does not cross it or has no length
                fractions.accept(fraction);
            }
        }
    }
}
