package org.sami.crw.sim.hull;

import java.util.SplittableRandom;

/**
 * What current and wind do to one hull: the current carries it along, the wind pushes it through the water with a small part of
 * its speed, in gusts.
 */
final class Weather {
    /** Part of the wind's speed with which it pushes a small hull. */
    static final double LEEWAY = 0.03;

    private static final double GUSTS = 0.25; // standard deviation, as a part of the wind's speed
    private static final double GUST_S = 10;

    private final double currentEastMps;
    private final double currentNorthMps;
    private final double windEastMps;
    private final double windNorthMps;
    private final boolean isCalm;
    private final GaussMarkovError gust;

    Weather(Conditions conditions, SplittableRandom random) {
        Flow current = conditions.current();
        Flow wind = conditions.wind();
        currentEastMps = current.eastMps();
        currentNorthMps = current.northMps();
        windEastMps = wind.eastMps();
        windNorthMps = wind.northMps();
        isCalm = current.isNone() && wind.isNone();
        gust = new GaussMarkovError(wind.isNone() ? 0 : GUSTS, GUST_S, random);
    }

    /** Whether a hull is left where it is. */
    boolean isCalm() {
        return isCalm;
    }

    void step(double seconds) {
        gust.step(seconds);
    }

    /** How fast a hull drifts eastward, in m/s over ground. */
    double eastMps() {
        return currentEastMps - leeway() * windEastMps;
    }

    /** How fast a hull drifts northward, in m/s over ground. */
    double northMps() {
        return currentNorthMps - leeway() * windNorthMps;
    }

    /** How strong the wind blows now, in m/s. */
    double windMps() {
        return Math.hypot(windEastMps, windNorthMps) * Math.max(0, 1 + gust.value());
    }

    private double leeway() {
        return LEEWAY * Math.max(0, 1 + gust.value());
    }
}
