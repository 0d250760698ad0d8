package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;

/** How far, how fast and how narrowly a boat drives, as far as it knows: bases divide work and plan ways by it. Immutable. */
public final class BoatPerformance {
    /** A boat that knows nothing of it. */
    public static final BoatPerformance UNKNOWN =
            new BoatPerformance(OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.empty());

    static final double MOST_METRES_PER_PERCENT = 1_000_000;
    static final double MOST_TURNING_RADIUS_M = 1000;
    static final double LEAST_METRES_PER_PERCENT = 0.01;
    private static final double LEAST_CRUISE_MPS = 0.05;
    private static final String METRES_PER_PERCENT = "metresPerPercent";
    private static final String CRUISE = "cruise";
    private static final String TURN = "turn";
    private static final String POWER = "power";

    private final OptionalDouble metresPerPercent;
    private final OptionalDouble cruiseMps;
    private final OptionalDouble turningRadiusM;
    private final Optional<PowerCurve> power;

    /**
     * Makes one of checked values, each empty where the boat does not know it; a value out of its range is an {@link IllegalArgumentException}.
     *
     * @param metresPerPercent mean distance on one percent of charge, 0.01 to 1,000,000 m
     * @param cruiseMps its speed on paths that name none, 0.05 to 50 m/s
     * @param turningRadiusM radius of its narrowest turn at that speed, 0 to 1000 m; 0 for a boat that turns on the spot
     */
    public BoatPerformance(OptionalDouble metresPerPercent, OptionalDouble cruiseMps, OptionalDouble turningRadiusM) {
        this(metresPerPercent, cruiseMps, turningRadiusM, Optional.empty());
    }

    private BoatPerformance(
            OptionalDouble metresPerPercent,
            OptionalDouble cruiseMps,
            OptionalDouble turningRadiusM,
            Optional<PowerCurve> power) {
        this.power = power;
        this.metresPerPercent = Objects.requireNonNull(metresPerPercent, METRES_PER_PERCENT);
        this.cruiseMps = Objects.requireNonNull(cruiseMps, CRUISE);
        this.turningRadiusM = Objects.requireNonNull(turningRadiusM, TURN);
        check(METRES_PER_PERCENT, metresPerPercent, LEAST_METRES_PER_PERCENT, MOST_METRES_PER_PERCENT);
        check(CRUISE, cruiseMps, LEAST_CRUISE_MPS, Checks.MAX_SPEED_MPS);
        check(TURN, turningRadiusM, 0, MOST_TURNING_RADIUS_M);
    }

    /** The same boat, whose consumption depends on its speed. Where it does not say how far a percent takes it, that is so at its speed on paths that name none. */
    public BoatPerformance with(PowerCurve curve) {
        OptionalDouble metres = metresPerPercent.isPresent()
                ? metresPerPercent
                : OptionalDouble.of(curve.metresPerPercent(cruiseMps.orElse(MotionDefaults.CRUISE_SPEED_MPS)));
        return new BoatPerformance(metres, cruiseMps, turningRadiusM, Optional.of(curve));
    }

    private static void check(String name, OptionalDouble value, double least, double most) {
        if (value.isPresent()) {
            Checks.range(name, value.getAsDouble(), least, most);
        }
    }

    static BoatPerformance read(Fields in) throws LinkException {
        try {
            return new BoatPerformance(
                    number(in, METRES_PER_PERCENT),
                    number(in, CRUISE),
                    number(in, TURN),
                    in.has(POWER) ? Optional.of(PowerCurve.read(in.object(POWER))) : Optional.empty());
        } catch (Checks.BadValueException e) {
            throw in.refused(e);
        }
    }

    private static OptionalDouble number(Fields in, String name) throws LinkException {
        return in.has(name) ? OptionalDouble.of(in.number(name)) : OptionalDouble.empty();
    }

    /** Mean distance on one percent of charge, in metres. */
    public OptionalDouble metresPerPercent() {
        return metresPerPercent;
    }

    /** Distance on one percent of charge at a speed in m/s, in metres; the mean where it does not say how its consumption depends on speed. */
    public OptionalDouble metresPerPercent(double speedMps) {
        return power.isPresent() && speedMps > 0
                ? OptionalDouble.of(power.get().metresPerPercent(speedMps))
                : metresPerPercent;
    }

    /** What it uses by its speed; empty for a boat that does not know it, as for older ones. */
    public Optional<PowerCurve> power() {
        return power;
    }

    /** Its speed on paths that name none, in m/s. */
    public OptionalDouble cruiseMps() {
        return cruiseMps;
    }

    /** Radius of its narrowest turn at that speed, in metres. */
    public OptionalDouble turningRadiusM() {
        return turningRadiusM;
    }

    boolean isUnknown() {
        return !metresPerPercent.isPresent()
                && !cruiseMps.isPresent()
                && !turningRadiusM.isPresent()
                && !power.isPresent();
    }

    void write(JsonGenerator out) throws IOException {
        write(out, METRES_PER_PERCENT, metresPerPercent);
        write(out, CRUISE, cruiseMps);
        write(out, TURN, turningRadiusM);
        if (power.isPresent()) {
            out.writeObjectFieldStart(POWER);
            power.get().write(out);
            out.writeEndObject();
        }
    }

    private static void write(JsonGenerator out, String name, OptionalDouble value) throws IOException {
        if (value.isPresent()) {
            out.writeNumberField(name, value.getAsDouble());
        }
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof BoatPerformance
                && metresPerPercent.equals(((BoatPerformance) other).metresPerPercent)
                && cruiseMps.equals(((BoatPerformance) other).cruiseMps)
                && turningRadiusM.equals(((BoatPerformance) other).turningRadiusM)
                && power.equals(((BoatPerformance) other).power);
    }

    @Override
    public int hashCode() {
        return Objects.hash(metresPerPercent, cruiseMps, turningRadiusM, power);
    }

    @Override
    public String toString() {
        return metresPerPercent + " m a percent, " + cruiseMps + " m/s, turns of " + turningRadiusM + " m"
                + (power.isPresent() ? ", " + power.get() : "");
    }
}
