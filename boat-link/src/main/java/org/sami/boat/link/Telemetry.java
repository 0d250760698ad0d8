package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;
import java.util.OptionalDouble;

/** Position, motion and mode of the boat. The newest counts, by the sequence number of its frame. */
public final class Telemetry extends LinkMessage {
    static final String TYPE = "telemetry";

    private final double latDeg;
    private final double lonDeg;
    private final double headingRad;
    private final double speedMps;
    private final double batteryPercent;
    private final BoatMode mode;
    private final long boatTimeMs;
    private final OptionalDouble altM;
    private final String givesWayTo;

    /** Makes a boat's message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Telemetry(
            double latDeg,
            double lonDeg,
            double headingRad,
            double speedMps,
            double batteryPercent,
            BoatMode mode,
            long boatTimeMs) {
        this(latDeg, lonDeg, headingRad, speedMps, batteryPercent, mode, boatTimeMs, OptionalDouble.empty());
    }

    /**
     * Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}.
     *
     * @param altM metres above the place of the take-off; empty for what does not fly
     */
    public Telemetry(
            double latDeg,
            double lonDeg,
            double headingRad,
            double speedMps,
            double batteryPercent,
            BoatMode mode,
            long boatTimeMs,
            OptionalDouble altM) {
        this(latDeg, lonDeg, headingRad, speedMps, batteryPercent, mode, boatTimeMs, altM, "");
    }

    /**
     * Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}.
     *
     * @param altM metres above the place of the take-off; empty for what does not fly
     * @param givesWayTo name of the boat to which it gives way on its path; empty text for none
     */
    public Telemetry(
            double latDeg,
            double lonDeg,
            double headingRad,
            double speedMps,
            double batteryPercent,
            BoatMode mode,
            long boatTimeMs,
            OptionalDouble altM,
            String givesWayTo) {
        this.latDeg = Checks.latitude(latDeg);
        this.lonDeg = Checks.longitude(lonDeg);
        this.headingRad = Checks.range("heading", headingRad, -7, 7);
        this.speedMps = Checks.range("speed", speedMps, -Checks.MAX_SPEED_MPS, Checks.MAX_SPEED_MPS);
        this.batteryPercent = Checks.range("battery", batteryPercent, 0, 100);
        this.mode = Objects.requireNonNull(mode, "mode");
        this.boatTimeMs = Checks.atLeastZero("time", boatTimeMs);
        this.altM = altM.isPresent() ? OptionalDouble.of(Checks.altitude(altM.getAsDouble())) : altM;
        this.givesWayTo = Checks.optionalName("givesWay", givesWayTo);
    }

    static Telemetry read(Fields in) throws LinkException {
        return new Telemetry(
                in.number("lat"),
                in.number("lon"),
                in.number("heading"),
                in.number("speed"),
                in.number("battery"),
                in.word("mode", BoatMode.class),
                in.integer("time"),
                in.has("alt") ? OptionalDouble.of(in.number("alt")) : OptionalDouble.empty(),
                in.textOrEmpty("givesWay"));
    }

    /** WGS 84 latitude in degrees. */
    public double latDeg() {
        return latDeg;
    }

    /** WGS 84 longitude in degrees. */
    public double lonDeg() {
        return lonDeg;
    }

    /** Heading in radians, clockwise from true north. */
    public double headingRad() {
        return headingRad;
    }

    /** Speed over ground along the heading in m/s; negative is astern. */
    public double speedMps() {
        return speedMps;
    }

    /** Charge in percent of full. */
    public double batteryPercent() {
        return batteryPercent;
    }

    /** The boat's mode. */
    public BoatMode mode() {
        return mode;
    }

    /** The boat's own clock in milliseconds. */
    public long boatTimeMs() {
        return boatTimeMs;
    }

    /** Metres above the place of the take-off; empty for what does not fly. */
    public OptionalDouble altM() {
        return altM;
    }

    /** Name of the boat to which this one gives way on its path; empty text where it gives way to none, or does not say so. */
    public String givesWayTo() {
        return givesWayTo;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeNumberField("lat", latDeg);
        out.writeNumberField("lon", lonDeg);
        out.writeNumberField("heading", headingRad);
        out.writeNumberField("speed", speedMps);
        out.writeNumberField("battery", batteryPercent);
        out.writeStringField("mode", mode.name());
        out.writeNumberField("time", boatTimeMs);
        if (altM.isPresent()) {
            out.writeNumberField("alt", altM.getAsDouble());
        }
        if (!givesWayTo.isEmpty()) {
            out.writeStringField("givesWay", givesWayTo);
        }
    }
}
