package org.sami.crw.sim.hull;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.sami.boat.server.vehicle.LocalFrame;

/**
 * The simulated targets on the ground: one in about seven cells of 0.001° by 0.001°. Their places depend only on the seed, so they are the same for all
 * aircraft of one world.
 */
public final class TargetField {
    private static final double CELL_DEG = 0.001;
    private static final double SHARE = 0.15; // of cells with a target
    private static final int NUMBERS = 10_000;

    private final long seed;

    /** The targets of one world. */
    public TargetField(long seed) {
        this.seed = seed;
    }

    /**
     * A target.
     *
     * @param number its own, from 0
     * @param latDeg where it lies, in degrees north
     * @param lonDeg where it lies, in degrees east
     */
    public record Target(int number, double latDeg, double lonDeg) {}

    /** The targets within so many metres of a place, in the order of their cells. */
    public List<Target> near(double latDeg, double lonDeg, double radiusM) {
        List<Target> seen = new ArrayList<>();
        LocalFrame here = new LocalFrame(latDeg, lonDeg);
        int south = cell(here.latDeg(0, -radiusM));
        int north = cell(here.latDeg(0, radiusM));
        int west = cell(here.lonDeg(-radiusM, 0));
        int east = cell(here.lonDeg(radiusM, 0));
        for (int row = south; row <= north; row++) {
            for (int column = west; column <= east; column++) {
                SplittableRandom random = new SplittableRandom(seed ^ (row * 0x9E3779B97F4A7C15L + column));
                if (random.nextDouble() < SHARE) {
                    Target target = new Target(
                            random.nextInt(NUMBERS),
                            (row + random.nextDouble()) * CELL_DEG,
                            (column + random.nextDouble()) * CELL_DEG);
                    if (here.distanceM(target.latDeg(), target.lonDeg()) <= radiusM) {
                        seen.add(target);
                    }
                }
            }
        }
        return seen;
    }

    private static int cell(double degrees) {
        return (int) Math.floor(degrees / CELL_DEG);
    }
}
