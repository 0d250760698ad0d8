package org.sami.crw.sim.layer;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.sami.spn.value.TextNumbers;

/**
 * The current of a water by place, from a table of points (CSV: {@code lat,lon,speed,direction}). Between and around the points it is the mean of all, weighted by
 * one over the square of the distance; so is its value far away. Immutable.
 *
 * @param points 1 to {@link #MOST}
 */
public record CurrentField(List<CurrentPoint> points) {
    /** The most points. */
    public static final int MOST = 1000;

    private static final String HEAD = "lat,lon,speed,direction";
    private static final double FASTEST_MPS = 5;
    private static final double AT_DEG2 = 1e-14; // square of a hundredth of a metre: the place of the point itself

    /**
     * The current at a point.
     *
     * @param latDeg in degrees
     * @param lonDeg in degrees
     * @param speedMps 0 to 5 m/s
     * @param directionDeg the direction to which the water flows, clockwise from true north, 0 to 360
     */
    public record CurrentPoint(double latDeg, double lonDeg, double speedMps, double directionDeg) {
        public CurrentPoint {
            if (!(Math.abs(latDeg) <= 90 && Math.abs(lonDeg) <= 180)) {
                throw new IllegalArgumentException(
                        "a point has a latitude and a longitude in degrees, not " + latDeg + " and " + lonDeg);
            }
            if (!(speedMps >= 0 && speedMps <= FASTEST_MPS && directionDeg >= 0 && directionDeg <= 360)) {
                throw new IllegalArgumentException(
                        "a current has 0 to 5 m/s and 0 to 360 degrees, not " + speedMps + " and " + directionDeg);
            }
        }

        private double eastMps() {
            return speedMps * StrictMath.sin(Math.toRadians(directionDeg));
        }

        private double northMps() {
            return speedMps * StrictMath.cos(Math.toRadians(directionDeg));
        }
    }

    /**
     * The current at a place, in m/s over ground.
     *
     * @param eastMps eastward
     * @param northMps northward
     */
    public record Drift(double eastMps, double northMps) {
        /** Still water. */
        public static final Drift NONE = new Drift(0, 0);
    }

    public CurrentField {
        points = List.copyOf(points);
        if (points.isEmpty() || points.size() > MOST) {
            throw new IllegalArgumentException("there are 1 to " + MOST + " points, not " + points.size());
        }
    }

    /** The current at a place in degrees. */
    public Drift at(double latDeg, double lonDeg) {
        double narrower = StrictMath.cos(Math.toRadians(latDeg));
        double east = 0;
        double north = 0;
        double sum = 0;
        for (CurrentPoint point : points) {
            double byEast = (point.lonDeg() - lonDeg) * narrower;
            double byNorth = point.latDeg() - latDeg;
            double weight = 1 / Math.max(AT_DEG2, byEast * byEast + byNorth * byNorth);
            east += weight * point.eastMps();
            north += weight * point.northMps();
            sum += weight;
        }
        return new Drift(east / sum, north / sum);
    }

    /**
     * Reads a file's text.
     *
     * @throws IllegalArgumentException saying in which line what is wrong
     */
    public static CurrentField parse(String text) {
        List<String> lines = text.lines().toList();
        if (lines.isEmpty() || !lines.get(0).replace(" ", "").equals(HEAD)) {
            throw new IllegalArgumentException("line 1: a table of currents begins with " + HEAD);
        }
        List<CurrentPoint> points = new ArrayList<>();
        for (int i = 1; i < lines.size(); i++) {
            if (!lines.get(i).isBlank()) {
                points.add(point(lines.get(i), i + 1));
            }
        }
        return new CurrentField(points);
    }

    private static CurrentPoint point(String line, int number) {
        double[] values = new double[4];
        String[] words = line.split(",", -1);
        for (int i = 0; i < values.length; i++) {
            OptionalDouble value =
                    words.length == values.length ? TextNumbers.real(words[i].strip()) : OptionalDouble.empty();
            values[i] = value.orElseThrow(() -> new IllegalArgumentException(
                    "line " + number + ": expected are four numbers, " + HEAD + ", not '" + line + "'"));
        }
        try {
            return new CurrentPoint(values[0], values[1], values[2], values[3]);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("line " + number + ": " + e.getMessage(), e);
        }
    }

    /** What {@link #parse} reads. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder(HEAD).append('\n');
        points.forEach(point -> text.append(point.latDeg())
                .append(',')
                .append(point.lonDeg())
                .append(',')
                .append(point.speedMps())
                .append(',')
                .append(point.directionDeg())
                .append('\n'));
        return text.toString();
    }
}
