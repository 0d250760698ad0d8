package org.sami.crw.report;

/**
 * Where a boat truly was at a moment.
 *
 * @param atMillis simulated time in milliseconds
 * @param eastM metres east of the area's centre
 * @param northM metres north of the area's centre
 * @param batteryPercent charge left, 0 to 100
 * @param altM metres above the place of the take-off; 0 for what does not fly
 */
public record TrackPoint(
        long atMillis,
        double eastM,
        double northM,
        double latDeg,
        double lonDeg,
        double speedMps,
        double batteryPercent,
        double altM) {
    /** Where a boat on the water was. */
    public TrackPoint(
            long atMillis,
            double eastM,
            double northM,
            double latDeg,
            double lonDeg,
            double speedMps,
            double batteryPercent) {
        this(atMillis, eastM, northM, latDeg, lonDeg, speedMps, batteryPercent, 0);
    }
}
