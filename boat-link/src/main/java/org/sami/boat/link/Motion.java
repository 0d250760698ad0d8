package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;

/**
 * Position and motion of a boat between two {@link Telemetry} messages. A boat near others sends it up to five times a second while it moves, and the base passes it
 * on as {@link Traffic}. The newest counts.
 */
public final class Motion extends LinkMessage {
    static final String TYPE = "motion";

    private final double latDeg;
    private final double lonDeg;
    private final double headingRad;
    private final double speedMps;
    private final BoatMode mode;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Motion(double latDeg, double lonDeg, double headingRad, double speedMps, BoatMode mode) {
        this.latDeg = Checks.latitude(latDeg);
        this.lonDeg = Checks.longitude(lonDeg);
        this.headingRad = Checks.range("heading", headingRad, -7, 7);
        this.speedMps = Checks.range("speed", speedMps, -Checks.MAX_SPEED_MPS, Checks.MAX_SPEED_MPS);
        this.mode = Objects.requireNonNull(mode, "mode");
    }

    static Motion read(Fields in) throws LinkException {
        return new Motion(
                in.number("lat"),
                in.number("lon"),
                in.number("heading"),
                in.number("speed"),
                in.word("mode", BoatMode.class));
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

    /** What the boat does. */
    public BoatMode mode() {
        return mode;
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
        out.writeStringField("mode", mode.name());
    }
}
