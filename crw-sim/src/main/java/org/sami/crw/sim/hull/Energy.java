package org.sami.crw.sim.hull;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.sami.boat.link.PowerCurve;

/**
 * What decides how much charge a simulated boat uses, as an option says it: {@code drag,hotel=12,battery=150}, or the boat's own curve, {@code 0:12,1.5:240,3:1700}.
 *
 * @param isDrag whether a metre costs the more the faster it is driven, four times as much at twice the speed; otherwise, without points, it costs the same at any speed
 * @param points power by speed, of the boat's own curve; empty without one
 * @param hotelW what everything but the motors uses while the boat is afloat, in watts; 0 with a curve, whose first point says it
 * @param batteryWh energy of a full battery, in watt-hours
 */
public record Energy(boolean isDrag, List<Point> points, double hotelW, double batteryWh) {
    /** Energy of a full battery where nobody says otherwise, in watt-hours: 14.8 V and 10 Ah. */
    public static final double USUAL_BATTERY_WH = 148;

    /** A metre costs the same at any speed, and rest costs nothing. */
    public static final Energy PER_METRE = new Energy(false, List.of(), 0, USUAL_BATTERY_WH);

    /** The greatest power, in watts. */
    public static final double MOST_W = 100_000;

    private static final double LEAST_BATTERY_WH = 1;
    private static final double MOST_BATTERY_WH = 1_000_000;
    private static final double PERCENT = 100;
    private static final String DRAG = "drag";
    private static final String HOTEL = "hotel";
    private static final String BATTERY = "battery";

    /**
     * A point of a curve.
     *
     * @param mps speed through the water, in m/s
     * @param watts power at it, that of everything on board
     */
    public record Point(double mps, double watts) {}

    /** Refuses values out of range, and a curve together with what it says already. */
    public Energy {
        points = List.copyOf(points);
        within("battery", batteryWh, LEAST_BATTERY_WH, MOST_BATTERY_WH, "Wh");
        within("hotel load", hotelW, 0, MOST_W, "W");
        points.forEach(point -> within("power", point.watts, 0, MOST_W, "W"));
        if (isDrag && !points.isEmpty()) {
            throw new IllegalArgumentException("a curve of its own goes without drag");
        }
        if (!isDrag && hotelW > 0) {
            throw new IllegalArgumentException("a hotel load goes with drag; a curve has it at 0 m/s");
        }
        if (!points.isEmpty()) {
            curve(points, batteryWh);
        }
    }

    private static void within(String what, double value, double least, double most, String unit) {
        if (!(value >= least && value <= most)) {
            throw new IllegalArgumentException(
                    "the " + what + " is " + text(least) + " to " + text(most) + " " + unit + ", not " + value);
        }
    }

    /**
     * Reads {@code drag}, {@code hotel=WATTS}, {@code battery=WH} and points {@code MPS:WATTS}, with commas between them.
     *
     * @throws IllegalArgumentException naming what cannot be read or does not fit
     */
    public static Energy parse(String text) {
        boolean drag = false;
        double hotelW = 0;
        double batteryWh = PER_METRE.batteryWh;
        List<Point> points = new ArrayList<>();
        for (String part : text.strip().toLowerCase(Locale.ROOT).split(",", -1)) {
            String word = part.strip();
            if (word.equals(DRAG)) {
                drag = true;
            } else if (word.startsWith(HOTEL + "=")) {
                hotelW = number(word.substring(HOTEL.length() + 1));
            } else if (word.startsWith(BATTERY + "=")) {
                batteryWh = number(word.substring(BATTERY.length() + 1));
            } else if (word.indexOf(':') > 0) {
                int colon = word.indexOf(':');
                points.add(new Point(number(word.substring(0, colon)), number(word.substring(colon + 1))));
            } else {
                throw new IllegalArgumentException("energy is drag, hotel=WATTS, battery=WH, or MPS:WATTS for two"
                        + " speeds or more, with commas; '" + word + "' is none of these");
            }
        }
        if (!drag && points.isEmpty()) {
            throw new IllegalArgumentException("energy needs drag, or a curve: MPS:WATTS for two speeds or more");
        }
        return new Energy(drag, points, hotelW, batteryWh);
    }

    private static double number(String text) {
        try {
            return Double.parseDouble(text.strip());
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("'" + text + "' is no number", e);
        }
    }

    /** Whether it is as if none had been given. */
    public boolean isPerMetre() {
        return !isDrag && points.isEmpty();
    }

    /** Whether the range of a boat follows from it alone. */
    public boolean isCurve() {
        return !points.isEmpty();
    }

    /**
     * What a hull uses by its speed; empty where a metre costs the same at any speed.
     *
     * @param percentPerM charge in percent that a metre at cruise speed costs its motors
     * @param cruiseMps cruise speed in m/s
     */
    Optional<PowerCurve> power(double percentPerM, double cruiseMps) {
        if (isPerMetre()) {
            return Optional.empty();
        }
        return Optional.of(
                isCurve()
                        ? curve(points, batteryWh)
                        : PowerCurve.drag(1 / percentPerM, cruiseMps, hotelW * PERCENT / batteryWh));
    }

    private static PowerCurve curve(List<Point> points, double batteryWh) {
        return new PowerCurve(
                points.stream().mapToDouble(Point::mps).toArray(),
                points.stream()
                        .mapToDouble(point -> point.watts * PERCENT / batteryWh)
                        .toArray());
    }

    /** The same as {@link #parse} reads it. */
    @Override
    public String toString() {
        List<String> parts = new ArrayList<>();
        if (isDrag) {
            parts.add(DRAG);
            parts.add(HOTEL + "=" + text(hotelW));
        }
        points.forEach(point -> parts.add(text(point.mps) + ":" + text(point.watts)));
        parts.add(BATTERY + "=" + text(batteryWh));
        return String.join(",", parts);
    }

    private static String text(double value) {
        return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
    }
}
