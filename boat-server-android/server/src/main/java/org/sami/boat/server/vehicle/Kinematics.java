package org.sami.boat.server.vehicle;

/** Position, heading and speed of a hull at this moment. */
public interface Kinematics {

    /** WGS 84 latitude in degrees; NaN as long as it is not known. */
    double latDeg();

    /** WGS 84 longitude in degrees; NaN as long as it is not known. */
    double lonDeg();

    /** Heading in radians, clockwise from true north, -π to π; NaN as long as it is not known. */
    double headingRad();

    /** Speed over ground along the heading in m/s; negative is astern; NaN as long as it is not known. */
    double speedMps();
}
