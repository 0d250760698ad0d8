package org.sami.crw.sim.hull;

import java.util.OptionalDouble;
import org.sami.spn.value.TextNumbers;

/**
 * Something that flows evenly over the whole area. Whether the direction is the one it goes to (a current) or the one it comes
 * from (a wind) is stated where it is used.
 *
 * @param speedMps 0 to {@link #FASTEST_MPS}
 * @param directionDeg clockwise from true north, 0 to 360
 */
public record Flow(double speedMps, double directionDeg) {
    /** A hurricane. */
    public static final double FASTEST_MPS = 50;

    /** Nothing flows. */
    public static final Flow NONE = new Flow(0, 0);

    private static final String AT = "@";

    /** Refuses what does not flow. */
    public Flow {
        if (!(speedMps >= 0 && speedMps <= FASTEST_MPS && directionDeg >= 0 && directionDeg <= 360)) {
            throw new IllegalArgumentException(
                    "a flow has a speed of 0 to 50 m/s and a direction of 0 to 360 degrees, not " + speedMps + " and "
                            + directionDeg);
        }
    }

    /** Whether nothing flows. */
    public boolean isNone() {
        return speedMps == 0;
    }

    /** The eastward part of its speed in m/s, in its direction. */
    public double eastMps() {
        return speedMps * StrictMath.sin(Math.toRadians(directionDeg));
    }

    /** The northward part of its speed in m/s, in its direction. */
    public double northMps() {
        return speedMps * StrictMath.cos(Math.toRadians(directionDeg));
    }

    /**
     * Reads a speed in m/s and a direction in degrees, as {@code 0.3@90}.
     *
     * @throws IllegalArgumentException saying what is expected, if it is none
     */
    public static Flow parse(String text) {
        String[] parts = text.split(AT, -1);
        if (parts.length == 2) {
            OptionalDouble speedMps = TextNumbers.real(parts[0]);
            OptionalDouble directionDeg = TextNumbers.real(parts[1]);
            if (speedMps.isPresent() && directionDeg.isPresent()) {
                return new Flow(speedMps.getAsDouble(), directionDeg.getAsDouble());
            }
        }
        throw new IllegalArgumentException(
                "expected is a speed in m/s, @ and a direction in degrees, such as 0.3@90, not '" + text + "'");
    }

    /** What {@link #parse} reads. */
    @Override
    public String toString() {
        return speedMps + AT + directionDeg;
    }
}
