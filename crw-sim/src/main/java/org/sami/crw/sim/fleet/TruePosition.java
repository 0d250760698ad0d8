package org.sami.crw.sim.fleet;

/**
 * Where a simulated boat truly was.
 *
 * @param timeMs virtual time
 * @param latDeg WGS 84 latitude in degrees
 * @param lonDeg WGS 84 longitude in degrees
 * @param eastM metres east of the fleet's base point
 * @param northM metres north of the fleet's base point
 */
public record TruePosition(long timeMs, double latDeg, double lonDeg, double eastM, double northM) {}
