package org.sami.crw.sim.hull;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.sami.boat.server.vehicle.Camera;
import org.sami.boat.server.vehicle.CameraShot;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.boat.server.vehicle.Vehicle;
import org.sami.crw.sim.layer.CurrentField;

/**
 * A hull with two motors, of a boat or, with {@link Rotors}, of a copter, moved by kinematics: the sum of the efforts sets the speed, their difference the turn rate, both
 * within the hull's limits. Positions are kept in metres east and north of the origin of a plane that all hulls of a
 * world share.
 *
 * <p>The battery drains with the distance driven, {@code b(t + τ) = b(t) - K d(τ) (1 + R)} with {@code R} drawn from
 * {@code U(-0.1, 0.1)} for each interval τ of {@link Conditions#dischargeIntervalS} (thesis 7.1.1), and never below zero; an empty one leaves the
 * motors without effect. A hull with a {@link HullConfig#power curve} drains in the same way by the power at its speed, at rest too. The distance is that through the water: holding out against a current costs as much as driving.
 * Equal seeds and equal efforts give equal tracks to the last bit.
 */
public final class SimulatedHull implements Vehicle {
    // gusts are drawn apart, so that calm water is as it always was
    private static final long GUST_SEED = 0x6775737473L;

    private final HullConfig config;
    private final LocalFrame frame;
    private final SimulatedBattery battery;
    private final Weather weather;
    private double eastM;
    private double northM;
    private double latDeg;
    private double lonDeg;
    private boolean isLocated; // latitude and longitude are those of the place in metres; computed when somebody asks
    private double headingRad;
    private double speedMps; // through the water
    private double turnRateRadPerS;
    private double port;
    private double starboard;
    private double distanceM;
    private int recharges;
    private int pictures;
    private Camera camera = this::count;
    private Optional<BatterySwap> swap = Optional.empty();
    private boolean underWay;
    private final Optional<Rotors> rotors;

    /** A hull in calm water, at rest with a full battery, its bow to the north, at a place on the plane of its world. */
    public SimulatedHull(HullConfig config, LocalFrame frame, double eastM, double northM, long seed) {
        this(config, Conditions.CALM, frame, eastM, northM, seed);
    }

    /** A hull at rest with a full battery, its bow to the north, at a place on the plane of its world. */
    public SimulatedHull(
            HullConfig config, Conditions conditions, LocalFrame frame, double eastM, double northM, long seed) {
        this.config = config;
        this.frame = frame;
        this.eastM = eastM;
        this.northM = northM;
        battery = new SimulatedBattery(new SplittableRandom(seed), conditions.dischargeIntervalS());
        rotors = config.rotors().map(Rotors::new);
        weather = new Weather(conditions, new SplittableRandom(seed ^ GUST_SEED));
    }

    @Override
    public double latDeg() {
        locate();
        return latDeg;
    }

    @Override
    public double lonDeg() {
        locate();
        return lonDeg;
    }

    @Override
    public double headingRad() {
        return headingRad;
    }

    /** Speed over ground along the heading: through the water, and what current and wind add to it. */
    @Override
    public double speedMps() {
        if (weather.isCalm() || rotors.isPresent()) {
            return speedMps;
        }
        return speedMps
                + weather.eastMps() * StrictMath.sin(headingRad)
                + weather.northMps() * StrictMath.cos(headingRad);
    }

    @Override
    public double batteryPercent() {
        return battery.percent();
    }

    /** True position: metres east of the world's origin. */
    public double eastM() {
        return eastM;
    }

    /** True position: metres north of the world's origin. */
    public double northM() {
        return northM;
    }

    /** Turn rate in radians a second, positive to starboard. */
    public double turnRateRadPerS() {
        return turnRateRadPerS;
    }

    /** Metres driven through the water since the start, ahead and astern. */
    public double distanceM() {
        return distanceM;
    }

    /** How many times the battery has been recharged. */
    public int recharges() {
        return recharges;
    }

    /** A camera that counts its pictures; a world in which there is something to be seen sets another one. */
    @Override
    public Optional<Camera> camera() {
        return Optional.of(camera);
    }

    /** From now on this camera takes the pictures; they are counted as before. */
    public void setCamera(Camera seeing) {
        camera = () -> {
            pictures++;
            return seeing.take();
        };
    }

    private CameraShot count() {
        pictures++;
        return CameraShot.withoutFile();
    }

    /** How many pictures its camera has taken. */
    public int pictures() {
        return pictures;
    }

    @Override
    public OptionalDouble altM() {
        return rotors.map(own -> OptionalDouble.of(own.altM())).orElse(OptionalDouble.empty());
    }

    @Override
    public void setAltitude(double altM) {
        rotors.ifPresent(own -> own.setAltitude(altM));
    }

    @Override
    public boolean isAtAltitude() {
        return rotors.map(Rotors::isAtAltitude).orElse(true);
    }

    @Override
    public void setMotors(double portEffort, double starboardEffort) {
        port = effort(portEffort);
        starboard = effort(starboardEffort);
    }

    /** From now on a boat is also carried by the current at its place. */
    public void setCurrents(CurrentField currents) {
        weather.setCurrents(currents, this::latDeg, this::lonDeg);
    }

    /** From now on there is a quay where its battery is swapped. */
    public void setQuay(Quay quay) {
        swap = Optional.of(new BatterySwap(quay));
    }

    /** The boat was commanded to go somewhere, even if it is there already: at the quay its battery is swapped from now on. */
    public void putToUse() {
        swap.ifPresent(BatterySwap::use);
    }

    /** Whether the boat has a way to go now: as long as it has, nobody swaps its battery, even where it waits at the quay. */
    public void setUnderWay(boolean underWay) {
        this.underWay = underWay;
    }

    /** Somebody swaps or fills the battery. */
    public void recharge() {
        battery.set(100);
        recharges++;
    }

    /** Somebody sets the charge, to try what a low battery does. */
    public void setBatteryPercent(double percent) {
        if (!(percent >= 0 && percent <= 100)) {
            throw new IllegalArgumentException("a charge of " + percent + " %");
        }
        battery.set(percent);
    }

    /** How strong the wind blows where it is, in m/s. */
    double windMps() {
        return weather.windMps();
    }

    /** Lets time pass. */
    public void step(double seconds) {
        if (!(seconds > 0)) {
            throw new IllegalArgumentException("a step of " + seconds + " s");
        }
        if (swap.isPresent() && swap.get().pass(seconds, eastM, northM, speedMps, underWay || altM().orElse(0) > 0)) {
            recharge();
        }
        if (rotors.isPresent()) {
            fly(seconds, rotors.get());
        } else {
            drift(seconds);
        }
        double speedBefore = speedMps;
        drive(seconds);
        if (config.power().isPresent() && !battery.isEmpty()) {
            battery.drain(config.power().get().percent((speedBefore + speedMps) / 2, seconds));
        }
        battery.step(seconds);
    }

    /** The flight controller holds its position against the wind, which moves the copter no further than its GPS says. */
    private void fly(double seconds, Rotors own) {
        weather.step(seconds);
        battery.set(Math.max(0, battery.percent() - own.step(seconds, !battery.isEmpty())));
    }

    /** What current and wind do; it costs no charge. */
    private void drift(double seconds) {
        if (!weather.isCalm()) {
            weather.step(seconds);
            eastM += weather.eastMps() * seconds;
            northM += weather.northMps() * seconds;
            isLocated = false;
        }
    }

    /** What the motors do. */
    private void drive(double seconds) {
        double power = !battery.isEmpty() && rotors.map(Rotors::isFree).orElse(true) ? 1 : 0;
        double wantedMps = power * (port + starboard) / 2 * config.topSpeedMps();
        double wantedTurn = power * (port - starboard) / 2 * config.maxTurnRateRadPerS();
        if (wantedMps == 0 && wantedTurn == 0 && speedMps == 0 && turnRateRadPerS == 0) {
            return; // lies still
        }
        double speedBefore = speedMps;
        double headingBefore = headingRad;
        speedMps = approach(speedMps, wantedMps, config.maxAccelerationMps2() * seconds);
        turnRateRadPerS = approach(turnRateRadPerS, wantedTurn, config.maxTurnAccelerationRadPerS2() * seconds);
        double turned = turnRateRadPerS * seconds;
        move((speedBefore + speedMps) / 2 * seconds, headingBefore + turned / 2);
        headingRad = PlaneMath.sameTurn(headingBefore + turned);
    }

    private void move(double alongM, double courseRad) {
        if (alongM == 0) {
            return;
        }
        eastM += alongM * StrictMath.sin(courseRad);
        northM += alongM * StrictMath.cos(courseRad);
        isLocated = false;
        double drivenM = Math.abs(alongM);
        distanceM += drivenM;
        if (config.power().isEmpty()) {
            battery.drain(config.batteryPercentPerM() * drivenM);
        }
    }

    private void locate() {
        if (!isLocated) {
            latDeg = frame.latDeg(eastM, northM);
            lonDeg = frame.lonDegOn(latDeg, eastM);
            isLocated = true;
        }
    }

    private static double approach(double from, double to, double most) {
        return from + Math.max(-most, Math.min(most, to - from));
    }

    private static double effort(double value) {
        if (Double.isNaN(value)) {
            throw new IllegalArgumentException("an effort that is no number");
        }
        return Math.max(-1, Math.min(1, value));
    }
}
