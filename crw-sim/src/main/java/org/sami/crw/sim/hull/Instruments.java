package org.sami.crw.sim.hull;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.sami.boat.server.vehicle.Camera;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.boat.server.vehicle.Sensor;
import org.sami.boat.server.vehicle.Vehicle;
import org.sami.boat.server.vehicle.VesselInSight;
import org.sami.crw.sim.layer.Sonar;
import org.sami.crw.sim.layer.WaterLayers;

/**
 * A hull as its boat server knows it: through a GPS and a compass whose errors wander, and through its sensors. The truth stays
 * with the hull. Without noise the server knows the truth to the last bit.
 */
public final class Instruments implements Vehicle {
    private static final double GPS_S = 20; // a receiver filters: its error is nearly the same a second later
    private static final long JUMP_SEED = 0x6a756d70L; // drawn apart, so that what does not jump is as it always was
    private static final long FIXES_SEED = 0x66697865L; // likewise
    private static final long SONAR_SEED = 0x736f6e61L; // likewise
    private static final double COMPASS_S = 2; // waves

    private final SimulatedHull hull;
    private final long seed;
    private final GaussMarkovError eastM;
    private final GaussMarkovError northM;
    private final GaussMarkovError headingRad;
    private final JumpingError jump;
    private final boolean exactGps;
    private final Optional<LoggedFixes> fixes; // empty: a position at any time
    private final List<Sensor> sensors = new ArrayList<>();
    private Supplier<List<VesselInSight>> vesselsInSight = List::of;
    private double trueLatDeg = Double.NaN; // where the hull was when the next two were computed
    private double trueLonDeg;
    private double shownLatDeg;
    private double shownLonDeg;
    private boolean hasFix; // these two are of the newest position

    /**
     * The instruments of a hull.
     *
     * @param seed of their errors
     * @param fieldSeed of what there is to be measured; equal for all boats of one water
     */
    public Instruments(SimulatedHull hull, Conditions conditions, long seed, long fieldSeed) {
        this.hull = hull;
        this.seed = seed;
        SplittableRandom seeds = new SplittableRandom(seed);
        fixes = conditions.receiver() == Receiver.LOGGED
                ? Optional.of(new LoggedFixes(new SplittableRandom(seed ^ FIXES_SEED)))
                : Optional.empty();
        exactGps = conditions.hasExactPositions() && fixes.isEmpty();
        eastM = new GaussMarkovError(conditions.gpsNoiseM(), GPS_S, seeds.split());
        northM = new GaussMarkovError(conditions.gpsNoiseM(), GPS_S, seeds.split());
        headingRad = new GaussMarkovError(Math.toRadians(conditions.compassNoiseDeg()), COMPASS_S, seeds.split());
        if (hull.altM().isPresent()) {
            sensors.add(new TargetCamera(hull, fieldSeed));
            sensors.add(new WindSensor(hull::windMps));
        } else {
            for (SensorSetting setting : conditions.sensors()) {
                sensors.add(new FieldSensor(setting, hull, fieldSeed, seeds.split()));
            }
        }
        jump = new JumpingError(
                conditions.gpsJumpM(),
                GPS_S,
                conditions.receiver().jumpIntervalS(),
                new SplittableRandom(seed ^ JUMP_SEED));
    }

    /**
     * Adds a lookout for vessels that are not of the boat's base; before the server asks for the sensors.
     *
     * @param reports of what it sees, for the base
     * @param inSight what it sees, for the boat
     */
    public void lookOut(Sensor reports, Supplier<List<VesselInSight>> inSight) {
        sensors.add(reports);
        vesselsInSight = inSight;
    }

    /** Puts a boat on water that differs by place, which carries the hull and which its sonar measures; before the server asks for the sensors. */
    public void on(WaterLayers layers) {
        if (hull.altM().isEmpty()) {
            layers.currents().ifPresent(hull::setCurrents);
            layers.depths()
                    .ifPresent(depths -> sensors.add(new Sonar(depths, hull::latDeg, hull::lonDeg, seed ^ SONAR_SEED)));
        }
    }

    @Override
    public List<VesselInSight> vesselsInSight() {
        return vesselsInSight.get();
    }

    /** Lets time pass for the errors; the hull's own time passes elsewhere. */
    public void step(double seconds) {
        eastM.step(seconds);
        northM.step(seconds);
        headingRad.step(seconds);
        jump.step(seconds);
        if (fixes.isEmpty() || fixes.get().step(seconds)) {
            trueLatDeg = Double.NaN;
            hasFix = false;
        }
    }

    @Override
    public double latDeg() {
        if (exactGps) {
            return hull.latDeg();
        }
        receive();
        return shownLatDeg;
    }

    @Override
    public double lonDeg() {
        if (exactGps) {
            return hull.lonDeg();
        }
        receive();
        return shownLonDeg;
    }

    private void receive() {
        if (fixes.isPresent() && hasFix) {
            return;
        }
        hasFix = true;
        if (trueLatDeg != hull.latDeg() || trueLonDeg != hull.lonDeg()) {
            trueLatDeg = hull.latDeg();
            trueLonDeg = hull.lonDeg();
            LocalFrame plane = new LocalFrame(trueLatDeg, trueLonDeg);
            double offEastM = eastM.value() + jump.eastM();
            shownLatDeg = plane.latDeg(offEastM, northM.value() + jump.northM());
            shownLonDeg = plane.lonDegOn(shownLatDeg, offEastM);
        }
    }

    @Override
    public double headingRad() {
        return PlaneMath.sameTurn(hull.headingRad()
                + headingRad.value()
                + fixes.map(LoggedFixes::compassOffRad).orElse(0.0));
    }

    @Override
    public double speedMps() {
        return hull.speedMps();
    }

    @Override
    public double batteryPercent() {
        return hull.batteryPercent();
    }

    @Override
    public List<Sensor> sensors() {
        return List.copyOf(sensors);
    }

    @Override
    public Optional<Camera> camera() {
        return hull.camera();
    }

    @Override
    public OptionalDouble altM() {
        return hull.altM();
    }

    @Override
    public void setAltitude(double altM) {
        hull.setAltitude(altM);
    }

    @Override
    public boolean isAtAltitude() {
        return hull.isAtAltitude();
    }

    @Override
    public void setMotors(double port, double starboard) {
        hull.setMotors(port, starboard);
    }
}
