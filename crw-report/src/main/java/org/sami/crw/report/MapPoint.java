package org.sami.crw.report;

/**
 * A place on the map of a run.
 *
 * @param latDeg WGS 84 latitude in degrees
 * @param lonDeg WGS 84 longitude in degrees
 * @param eastM metres east of the area's centre
 * @param northM metres north of the area's centre
 */
public record MapPoint(double latDeg, double lonDeg, double eastM, double northM) {}
