package org.sami.crw.sim.hull;

import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.sami.crw.sim.layer.CurrentField;
import org.sami.crw.sim.layer.CurrentField.Drift;

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
    private Optional<Supplier<Drift>> currents = Optional.empty(); // by place
    private Drift drift = Drift.NONE; // of them, where the hull is

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

    /** From now on the hull is also carried by the current at its place. */
    void setCurrents(CurrentField field, DoubleSupplier latDeg, DoubleSupplier lonDeg) {
        currents = Optional.of(() -> field.at(latDeg.getAsDouble(), lonDeg.getAsDouble()));
    }

    /** Whether a hull is left where it is. */
    boolean isCalm() {
        return isCalm && currents.isEmpty();
    }

    void step(double seconds) {
        gust.step(seconds);
        currents.ifPresent(here -> drift = here.get());
    }

    /** How fast a hull drifts eastward, in m/s over ground. */
    double eastMps() {
        return currentEastMps + drift.eastMps() - leeway() * windEastMps;
    }

    /** How fast a hull drifts northward, in m/s over ground. */
    double northMps() {
        return currentNorthMps + drift.northMps() - leeway() * windNorthMps;
    }

    /** How strong the wind blows now, in m/s. */
    double windMps() {
        return Math.hypot(windEastMps, windNorthMps) * Math.max(0, 1 + gust.value());
    }

    private double leeway() {
        return LEEWAY * Math.max(0, 1 + gust.value());
    }
}
