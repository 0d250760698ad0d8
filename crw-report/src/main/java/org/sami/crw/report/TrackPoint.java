package org.sami.crw.report;

/**
 * Where a boat truly was at a moment.
 *
 * @param atMillis simulated time in milliseconds
 * @param eastM metres east of the area's centre
 * @param northM metres north of the area's centre
 * @param batteryPercent charge left, 0 to 100
 */
public record TrackPoint(
        long atMillis,
        double eastM,
        double northM,
        double latDeg,
        double lonDeg,
        double speedMps,
        double batteryPercent) {}
