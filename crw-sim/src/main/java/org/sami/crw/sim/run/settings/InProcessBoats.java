package org.sami.crw.sim.run.settings;

import java.util.Objects;
import java.util.OptionalDouble;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Energy;
import org.sami.crw.sim.layer.WaterLayers;
import org.sami.crw.sim.link.Radio;
import org.sami.crw.sim.vessel.ForeignVessels;

/**
 * How simulated boats in the process of a run fare. Boats behind TCP have water, batteries and a network of their own.
 *
 * @param conditions on the water; where boats behind TCP do not say how they fare in theirs, these are planned with
 * @param charges of the batteries at the start
 * @param rangeM how far a full battery takes a boat on average, in metres; empty for the usual range
 * @param radio between base and boats; the base's is in the middle of the quay
 * @param energy what decides how much charge boats use
 * @param vessels on the water that are not of the fleet
 * @param layers of the water, by place
 */
public record InProcessBoats(
        Conditions conditions,
        InitialCharges charges,
        OptionalDouble rangeM,
        Radio radio,
        Energy energy,
        ForeignVessels vessels,
        WaterLayers layers) {
    /** The shortest range, in metres. */
    public static final double SHORTEST_RANGE_M = 100;

    /** The longest range, in metres. */
    public static final double LONGEST_RANGE_M = 1_000_000;

    /** Boats with full batteries and a perfect radio in calm water. */
    public static final InProcessBoats CALM = new InProcessBoats(
            Conditions.CALM,
            InitialCharges.FULL,
            OptionalDouble.empty(),
            Radio.PERFECT,
            Energy.PER_METRE,
            ForeignVessels.NONE,
            WaterLayers.NONE);

    /**
     * Boats within the limits.
     *
     * @throws IllegalArgumentException for a range out of its limits, or one that a curve of consumption gives
     */
    public InProcessBoats {
        Objects.requireNonNull(conditions, "conditions");
        Objects.requireNonNull(charges, "charges");
        Objects.requireNonNull(radio, "radio");
        Objects.requireNonNull(energy, "energy");
        Objects.requireNonNull(vessels, "vessels");
        Objects.requireNonNull(layers, "layers");
        double metres = rangeM.orElse(SHORTEST_RANGE_M);
        if (!(metres >= SHORTEST_RANGE_M && metres <= LONGEST_RANGE_M)) {
            throw new IllegalArgumentException("a full battery lasts for 100 to 1000000 m, not " + metres);
        }
        if (energy.isCurve() && rangeM.isPresent()) {
            throw new IllegalArgumentException("a range follows from the boats' curve: give one of the two");
        }
    }

    InProcessBoats on(Conditions water) {
        return new InProcessBoats(water, charges, rangeM, radio, energy, vessels, layers);
    }

    InProcessBoats with(InitialCharges others) {
        return new InProcessBoats(conditions, others, rangeM, radio, energy, vessels, layers);
    }

    InProcessBoats withRangeM(double metres) {
        return new InProcessBoats(conditions, charges, OptionalDouble.of(metres), radio, energy, vessels, layers);
    }

    InProcessBoats over(Radio other) {
        return new InProcessBoats(conditions, charges, rangeM, other, energy, vessels, layers);
    }

    InProcessBoats with(Energy other) {
        return new InProcessBoats(conditions, charges, rangeM, radio, other, vessels, layers);
    }

    InProcessBoats among(ForeignVessels others) {
        return new InProcessBoats(conditions, charges, rangeM, radio, energy, others, layers);
    }

    InProcessBoats on(WaterLayers newLayers) {
        return new InProcessBoats(conditions, charges, rangeM, radio, energy, vessels, newLayers);
    }

    /**
     * Refuses what only boats have.
     *
     * @throws IllegalArgumentException where the robots are copters, but a range or a consumption by speed is given
     */
    void requireFor(RobotKind robots) {
        if (robots != RobotKind.COPTER) {
            return;
        }
        if (rangeM.isPresent()) {
            throw new IllegalArgumentException("only boats have a range; copters fly for a time");
        }
        if (!energy.isPerMetre()) {
            throw new IllegalArgumentException("only boats use their battery by their speed; copters fly for a time");
        }
    }

    /**
     * Refuses what boats behind TCP have themselves.
     *
     * @param areBesides whether boats of this process are beside them, which may have sensors
     * @throws IllegalArgumentException for sensors, charges, a range, a consumption, a radio, other vessels or layers
     */
    void requireUnset(boolean areBesides) {
        if (!areBesides && !conditions.sensors().isEmpty()) {
            throw new IllegalArgumentException(
                    "boats behind TCP have their own water and sensors: see crw boat --help");
        }
        if (!charges.equals(InitialCharges.FULL)) {
            throw new IllegalArgumentException("boats behind TCP have their own batteries: see crw boat --help");
        }
        if (rangeM.isPresent()) {
            throw new IllegalArgumentException("boats behind TCP say their range themselves: see crw boat --help");
        }
        if (!energy.isPerMetre()) {
            throw new IllegalArgumentException("boats behind TCP say what they use themselves: see crw boat --help");
        }
        if (!radio.isPerfect()) {
            throw new IllegalArgumentException("boats behind TCP have a network of their own, and no simulated radio");
        }
        if (!vessels.isEmpty() || !layers.isEmpty()) {
            throw new IllegalArgumentException("boats behind TCP have their own water: see crw boat --help");
        }
    }
}
