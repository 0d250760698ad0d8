package org.sami.boat.mavlink;

/**
 * A place on the earth.
 *
 * @param latDeg degrees north, WGS 84
 * @param lonDeg degrees east, WGS 84
 */
record Position(double latDeg, double lonDeg) {
    private static final double HALF_TURN_DEG = 180;
    private static final double WHOLE_TURN_DEG = 360;

    /** Degrees north of another place. */
    double northDeg(Position of) {
        return latDeg - of.latDeg;
    }

    /** Degrees east of another place, the shorter way round the earth; negative is west. */
    double eastDeg(Position of) {
        double east = lonDeg - of.lonDeg;
        return east > HALF_TURN_DEG ? east - WHOLE_TURN_DEG : east < -HALF_TURN_DEG ? east + WHOLE_TURN_DEG : east;
    }

    /** The place at a fraction of the straight way to another one. */
    Position towards(Position to, double fraction) {
        double lon = lonDeg + to.eastDeg(this) * fraction;
        double wrapped = lon > HALF_TURN_DEG ? lon - WHOLE_TURN_DEG : lon < -HALF_TURN_DEG ? lon + WHOLE_TURN_DEG : lon;
        return new Position(latDeg + to.northDeg(this) * fraction, wrapped);
    }
}
