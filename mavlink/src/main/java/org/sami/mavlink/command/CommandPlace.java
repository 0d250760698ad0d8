package org.sami.mavlink.command;

/**
 * Where a command leads.
 *
 * @param latDeg degrees north, WGS 84
 * @param lonDeg degrees east, WGS 84
 * @param heightM metres over home; boats ignore it
 */
public record CommandPlace(double latDeg, double lonDeg, double heightM) {
    private static final double MAX_LAT = 90;
    private static final double MAX_LON = 180;

    /** A place.
     *
     * @throws IllegalArgumentException if it is not on the earth
     */
    public CommandPlace {
        if (!(Math.abs(latDeg) <= MAX_LAT && Math.abs(lonDeg) <= MAX_LON && Double.isFinite(heightM))) {
            throw new IllegalArgumentException("there is no place " + latDeg + ", " + lonDeg + ", " + heightM + " m");
        }
    }
}
