package org.sami.crw.proxy;

import org.sami.boat.link.BoatMode;

/**
 * The last reported position and motion of a boat, from telemetry or from a motion report between two of those.
 *
 * @param latDeg WGS 84, degrees
 * @param lonDeg WGS 84, degrees
 * @param headingRad radians clockwise from true north
 * @param speedMps speed in m/s along the heading, negative astern
 * @param atMs time of arrival at the base, on its clock
 */
record Sighting(double latDeg, double lonDeg, double headingRad, double speedMps, BoatMode mode, long atMs) {
    private static final double STILL_MPS = 0.1;

    /** Whether the boat lies still and is not under way. */
    boolean isAtRest() {
        boolean resting = mode == BoatMode.STOPPED || mode == BoatMode.HOLD || mode == BoatMode.FLEET_STOP;
        return resting && Math.abs(speedMps) < STILL_MPS;
    }
}
