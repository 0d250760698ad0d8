package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.sami.boat.link.Checks.BadValueException;

/**
 * A reading of one channel of one sensor, with place and time. Sent once to every client, at the sensor's own rate.
 */
public final class SensorReport extends LinkMessage {
    /** Most values in one reading. */
    public static final int MAX_VALUES = 64;

    static final String TYPE = "reading";

    private final String sensor;
    private final String channel;
    private final List<Double> values;
    private final String unit;
    private final double latDeg;
    private final double lonDeg;
    private final long boatTimeMs;

    /**
     * Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}.
     *
     * @param sensor names the instrument on the boat
     * @param channel what of it this is, as {@code temperature}
     * @param values one, or several that belong together, as of a profile; finite
     * @param unit of all values; empty for a number without one
     */
    public SensorReport(
            String sensor,
            String channel,
            List<Double> values,
            String unit,
            double latDeg,
            double lonDeg,
            long boatTimeMs) {
        this.sensor = Checks.id("sensor", sensor);
        this.channel = Checks.id("channel", channel);
        this.values = checked(values);
        this.unit = Checks.optionalId("unit", unit);
        this.latDeg = Checks.latitude(latDeg);
        this.lonDeg = Checks.longitude(lonDeg);
        this.boatTimeMs = Checks.atLeastZero("time", boatTimeMs);
    }

    private static List<Double> checked(List<Double> values) {
        if (values.isEmpty() || values.size() > MAX_VALUES) {
            throw new BadValueException("values", values.size() + " values; a reading has 1 to " + MAX_VALUES);
        }
        for (double value : values) {
            Checks.range("values", value, -Double.MAX_VALUE, Double.MAX_VALUE);
        }
        return Collections.unmodifiableList(new ArrayList<>(values));
    }

    static SensorReport read(Fields in) throws LinkException {
        JsonNode array = in.array("values");
        List<Double> values = new ArrayList<>();
        for (int i = 0; i < Math.min(array.size(), MAX_VALUES + 1); i++) {
            values.add(Fields.number(array.get(i), "/values/" + i));
        }
        return new SensorReport(
                in.text("sensor"),
                in.text("channel"),
                values,
                in.text("unit"),
                in.number("lat"),
                in.number("lon"),
                in.integer("time"));
    }

    /** Names the instrument. */
    public String sensor() {
        return sensor;
    }

    /** What of the instrument this is. */
    public String channel() {
        return channel;
    }

    /** What it measured; at least one value, all finite; unmodifiable. */
    public List<Double> values() {
        return values;
    }

    /** The unit of the values; empty for none. */
    public String unit() {
        return unit;
    }

    /** Position of the boat by its own estimate: WGS 84 latitude in degrees. */
    public double latDeg() {
        return latDeg;
    }

    /** Position of the boat by its own estimate: WGS 84 longitude in degrees. */
    public double lonDeg() {
        return lonDeg;
    }

    /** When, by the boat's own clock in milliseconds. */
    public long boatTimeMs() {
        return boatTimeMs;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeStringField("sensor", sensor);
        out.writeStringField("channel", channel);
        out.writeArrayFieldStart("values");
        for (double value : values) {
            out.writeNumber(value);
        }
        out.writeEndArray();
        out.writeStringField("unit", unit);
        out.writeNumberField("lat", latDeg);
        out.writeNumberField("lon", lonDeg);
        out.writeNumberField("time", boatTimeMs);
    }
}
