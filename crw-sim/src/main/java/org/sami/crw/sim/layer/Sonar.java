package org.sami.crw.sim.layer;

import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.function.DoubleSupplier;
import org.sami.boat.server.vehicle.Sensor;

/**
 * The sonar of a simulated boat: the depth where the hull truly is, with an error. It measures nothing on land or where the depth is not known. It has the name of
 * the sonar on a real boat's control board, so that what evaluates its readings takes both. For the boat's thread.
 */
public final class Sonar implements Sensor {
    /** Name of the instrument. */
    public static final String INSTRUMENT = "hds";

    /** Name of what it measures. */
    public static final String CHANNEL = "depth";

    /** Standard deviation of its error, in metres. */
    public static final double ERROR_M = 0.05;

    private static final long PERIOD_MS = 1000;

    private final DepthGrid depths;
    private final DoubleSupplier latDeg;
    private final DoubleSupplier lonDeg;
    private final SplittableRandom random;

    /**
     * A sonar.
     *
     * @param latDeg where the hull truly is
     * @param lonDeg where the hull truly is
     * @param seed of its errors
     */
    public Sonar(DepthGrid depths, DoubleSupplier latDeg, DoubleSupplier lonDeg, long seed) {
        this.depths = depths;
        this.latDeg = latDeg;
        this.lonDeg = lonDeg;
        random = new SplittableRandom(seed);
    }

    @Override
    public String name() {
        return INSTRUMENT;
    }

    @Override
    public String channel() {
        return CHANNEL;
    }

    @Override
    public String unit() {
        return "m";
    }

    @Override
    public long periodMs() {
        return PERIOD_MS;
    }

    /** The depth in metres; empty where there is none. */
    @Override
    public List<Double> read() {
        OptionalDouble depthM = depths.depthM(latDeg.getAsDouble(), lonDeg.getAsDouble());
        return depthM.isEmpty()
                ? Collections.emptyList()
                : Sensor.single(Math.max(0, depthM.getAsDouble() + ERROR_M * gaussian()));
    }

    /** Box and Muller's, with StrictMath: equal on every machine. */
    private double gaussian() {
        double radius = StrictMath.sqrt(-2 * StrictMath.log(1 - random.nextDouble()));
        return radius * StrictMath.cos(2 * Math.PI * random.nextDouble());
    }
}
