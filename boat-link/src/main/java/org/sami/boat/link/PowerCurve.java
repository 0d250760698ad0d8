package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.Arrays;

/**
 * The charge that a boat uses in an hour, in percent of full, by its speed through the water. The first point is at rest: the load of everything but the motors (hotel
 * load). Between two points, and past the last, power grows with the cube of the speed, as against drag that grows with its square. Immutable.
 */
public final class PowerCurve {
    /** Most points of a curve. */
    public static final int MAX_POINTS = 32;

    /** Most charge that is used in an hour, in percent of full. */
    public static final double MAX_PERCENT_PER_HOUR = 1_000_000;

    private static final double SECONDS_PER_HOUR = 3600;
    private static final String SPEED = "speeds";
    private static final String POWER = "percents";
    private static final int ECONOMY_STEPS = 20;

    private final double[] speedsMps;
    private final double[] percentsPerHour;

    /**
     * A curve through points; {@link IllegalArgumentException} where they are none.
     *
     * @param speedsMps 2 to {@value #MAX_POINTS}, rising from 0 to at most 50 m/s
     * @param percentsPerHour one for each speed, from 0 up, none less than the one before it, the last greater than 0
     */
    public PowerCurve(double[] speedsMps, double[] percentsPerHour) {
        this.speedsMps = speedsMps.clone();
        this.percentsPerHour = percentsPerHour.clone();
        int points = speedsMps.length;
        if (points < 2 || points > MAX_POINTS || points != percentsPerHour.length) {
            throw new Checks.BadValueException(
                    SPEED,
                    "a power curve has 2 to " + MAX_POINTS + " speeds and as many powers, not " + points + " and "
                            + percentsPerHour.length);
        }
        if (speedsMps[0] != 0) {
            throw new Checks.BadValueException(SPEED, "a power curve begins at 0 m/s, not " + speedsMps[0]);
        }
        for (int i = 0; i < points; i++) {
            Checks.speed(SPEED, speedsMps[i]);
            Checks.range(POWER, percentsPerHour[i], 0, MAX_PERCENT_PER_HOUR);
            if (i > 0 && !(speedsMps[i] > speedsMps[i - 1] && percentsPerHour[i] >= percentsPerHour[i - 1])) {
                throw new Checks.BadValueException(
                        SPEED, "speeds rise, and power does not fall: not so at " + speedsMps[i] + " m/s");
            }
        }
        if (percentsPerHour[points - 1] == 0) {
            throw new Checks.BadValueException(POWER, "a power curve ends with a power greater than 0");
        }
    }

    /**
     * That of a boat against drag, so that a metre at twice the speed costs four times as much.
     *
     * @param metresPerPercent how far its motors alone take it on one percent at a speed
     * @param atMps that speed
     * @param hotelPercentPerHour what everything else on board uses
     */
    public static PowerCurve drag(double metresPerPercent, double atMps, double hotelPercentPerHour) {
        return new PowerCurve(
                new double[] {0, atMps},
                new double[] {hotelPercentPerHour, hotelPercentPerHour + SECONDS_PER_HOUR * atMps / metresPerPercent});
    }

    static PowerCurve read(Fields in) throws LinkException {
        double[] speeds = numbers(in, SPEED);
        double[] percents = numbers(in, POWER);
        try {
            return new PowerCurve(speeds, percents);
        } catch (Checks.BadValueException e) {
            throw in.refused(e);
        }
    }

    private static double[] numbers(Fields in, String name) throws LinkException {
        JsonNode array = in.array(name);
        if (array.size() > MAX_POINTS) {
            throw new LinkException(
                    LinkException.Fault.BAD_VALUE, in.pointer(name), array.size() + " are more than " + MAX_POINTS);
        }
        double[] numbers = new double[array.size()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = Fields.number(array.get(i), in.pointer(name) + "/" + i);
        }
        return numbers;
    }

    void write(JsonGenerator out) throws IOException {
        write(out, SPEED, speedsMps);
        write(out, POWER, percentsPerHour);
    }

    private static void write(JsonGenerator out, String name, double[] numbers) throws IOException {
        out.writeArrayFieldStart(name);
        for (double number : numbers) {
            out.writeNumber(number);
        }
        out.writeEndArray();
    }

    /** What an hour at a speed costs, in percent of full; the same ahead and astern. */
    public double percentPerHour(double speedMps) {
        double mps = Math.abs(speedMps);
        int i = 1;
        while (i < speedsMps.length - 1 && mps > speedsMps[i]) {
            i++;
        }
        double before = cube(speedsMps[i - 1]);
        double part = (cube(mps) - before) / (cube(speedsMps[i]) - before);
        return percentsPerHour[i - 1] + part * (percentsPerHour[i] - percentsPerHour[i - 1]);
    }

    private static double cube(double value) {
        return value * value * value;
    }

    /** What some seconds at a speed cost, in percent of full. */
    public double percent(double speedMps, double seconds) {
        return percentPerHour(speedMps) * seconds / SECONDS_PER_HOUR;
    }

    /** How far one percent takes the boat at a speed, in metres; as much as {@link BoatPerformance} can say at most. */
    public double metresPerPercent(double speedMps) {
        double metres = SECONDS_PER_HOUR * speedMps / percentPerHour(speedMps);
        return Math.max(
                BoatPerformance.LEAST_METRES_PER_PERCENT, Math.min(BoatPerformance.MOST_METRES_PER_PERCENT, metres));
    }

    /** The speed between two at which one percent takes the boat farthest, in m/s: it is found to a twentieth of what lies between them. */
    public double economicMps(double leastMps, double mostMps) {
        double best = mostMps;
        for (int i = 1; i <= ECONOMY_STEPS; i++) {
            double mps = mostMps - (mostMps - leastMps) * i / ECONOMY_STEPS;
            if (metresPerPercent(mps) > metresPerPercent(best)) {
                best = mps;
            }
        }
        return best;
    }

    /** The speeds of its points, in m/s. */
    public double[] speedsMps() {
        return speedsMps.clone();
    }

    /** The charge used in an hour at each of them, in percent of full. */
    public double[] percentsPerHour() {
        return percentsPerHour.clone();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof PowerCurve
                && Arrays.equals(speedsMps, ((PowerCurve) other).speedsMps)
                && Arrays.equals(percentsPerHour, ((PowerCurve) other).percentsPerHour);
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(speedsMps) + Arrays.hashCode(percentsPerHour);
    }

    @Override
    public String toString() {
        return Arrays.toString(percentsPerHour) + " % an hour at " + Arrays.toString(speedsMps) + " m/s";
    }
}
