package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;

/** Another boat as the base knows it, one row of {@link Traffic}. */
public final class NearbyBoat {
    private static final String TO_LAT = "toLat";
    private static final String TO_LON = "toLon";

    private final String boatId;
    private final double latDeg;
    private final double lonDeg;
    private final double headingRad;
    private final double headingEast; // computed once for all receivers of the row
    private final double headingNorth;
    private final double speedMps;
    private final BoatMode mode;
    private final long ageMs;
    private final boolean going;
    private final double toLatDeg; // 0 where unknown
    private final double toLonDeg;

    /** A boat without a known destination. */
    public NearbyBoat(
            String boatId,
            double latDeg,
            double lonDeg,
            double headingRad,
            double speedMps,
            BoatMode mode,
            long ageMs) {
        this(boatId, latDeg, lonDeg, headingRad, speedMps, mode, ageMs, Double.NaN, Double.NaN);
    }

    /**
     * Makes a row of checked values; a value out of its range is an {@link IllegalArgumentException}.
     *
     * @param toLatDeg next point of the boat's way, WGS 84 degrees; NaN where unknown
     * @param toLonDeg next point of the boat's way, WGS 84 degrees; NaN where unknown
     */
    public NearbyBoat(
            String boatId,
            double latDeg,
            double lonDeg,
            double headingRad,
            double speedMps,
            BoatMode mode,
            long ageMs,
            double toLatDeg,
            double toLonDeg) {
        this.boatId = Checks.id("boat", boatId);
        this.latDeg = Checks.latitude(latDeg);
        this.lonDeg = Checks.longitude(lonDeg);
        this.headingRad = Checks.range("heading", headingRad, -7, 7);
        headingEast = StrictMath.sin(headingRad);
        headingNorth = StrictMath.cos(headingRad);
        this.speedMps = Checks.range("speed", speedMps, -Checks.MAX_SPEED_MPS, Checks.MAX_SPEED_MPS);
        this.mode = Objects.requireNonNull(mode, "mode");
        this.ageMs = Checks.atLeastZero("age", ageMs);
        going = !(Double.isNaN(toLatDeg) && Double.isNaN(toLonDeg));
        this.toLatDeg = going ? Checks.range(TO_LAT, toLatDeg, -90, 90) : 0;
        this.toLonDeg = going ? Checks.range(TO_LON, toLonDeg, -180, 180) : 0;
    }

    static NearbyBoat read(Fields in) throws LinkException {
        return new NearbyBoat(
                in.text("boat"),
                in.number("lat"),
                in.number("lon"),
                in.number("heading"),
                in.number("speed"),
                in.word("mode", BoatMode.class),
                in.integer("age"),
                in.numberOr(TO_LAT, Double.NaN),
                in.numberOr(TO_LON, Double.NaN));
    }

    void write(JsonGenerator out) throws IOException {
        out.writeStartObject();
        out.writeStringField("boat", boatId);
        out.writeNumberField("lat", latDeg);
        out.writeNumberField("lon", lonDeg);
        out.writeNumberField("heading", headingRad);
        out.writeNumberField("speed", speedMps);
        out.writeStringField("mode", mode.name());
        out.writeNumberField("age", ageMs);
        if (isGoing()) {
            out.writeNumberField(TO_LAT, toLatDeg);
            out.writeNumberField(TO_LON, toLonDeg);
        }
        out.writeEndObject();
    }

    /** The boat's name. */
    public String boatId() {
        return boatId;
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

    /** The part to the east of a unit vector along the heading. */
    public double headingEast() {
        return headingEast;
    }

    /** The part to the north of that vector. */
    public double headingNorth() {
        return headingNorth;
    }

    /** Speed over ground along the heading in m/s; negative is astern. */
    public double speedMps() {
        return speedMps;
    }

    /** What the boat does. */
    public BoatMode mode() {
        return mode;
    }

    /** Age of the row when it was sent, in milliseconds. */
    public long ageMs() {
        return ageMs;
    }

    /** Whether the boat's destination is known. */
    public boolean isGoing() {
        return going;
    }

    /** WGS 84 latitude in degrees of the next point of its way; only where it {@link #isGoing}. */
    public double toLatDeg() {
        return toLatDeg;
    }

    /** WGS 84 longitude in degrees of the next point of its way; only where it {@link #isGoing}. */
    public double toLonDeg() {
        return toLonDeg;
    }
}
