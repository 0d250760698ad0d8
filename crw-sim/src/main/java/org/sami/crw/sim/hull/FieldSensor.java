package org.sami.crw.sim.hull;

import java.util.List;
import java.util.SplittableRandom;
import org.sami.boat.server.vehicle.Sensor;

/** A simulated sensor: the value of a field where the hull truly is, and a little noise. */
final class FieldSensor implements Sensor {
    private static final String INSTRUMENT = "water";
    private static final double NOISE = 0.01; // standard deviation, as a part of the field's spread

    private final SensorSetting setting;
    private final SimulatedHull hull;
    private final ScalarField field;
    private final SplittableRandom random;

    FieldSensor(SensorSetting setting, SimulatedHull hull, long fieldSeed, SplittableRandom random) {
        this.setting = setting;
        this.hull = hull;
        field = new ScalarField(setting.kind(), fieldSeed);
        this.random = random;
    }

    @Override
    public String name() {
        return INSTRUMENT;
    }

    @Override
    public String channel() {
        return setting.kind().word();
    }

    @Override
    public String unit() {
        return setting.kind().unit();
    }

    @Override
    public long periodMs() {
        return setting.periodMs();
    }

    @Override
    public List<Double> read() {
        double noise = new GaussMarkovError(NOISE * setting.kind().spread(), 1, random).value();
        return Sensor.single(field.at(hull.latDeg(), hull.lonDeg()) + noise);
    }
}
