package org.sami.spn.value;

/**
 * A geographic point on the WGS-84 ellipsoid: latitude in degrees (-90 to 90, north positive), longitude in degrees
 * (-180 to 180, east positive), altitude in metres above the ellipsoid.
 */
public record GeoPoint(double latDeg, double lonDeg, double altM) implements Value {
    public GeoPoint {
        if (!(latDeg >= -90 && latDeg <= 90)) {
            throw new IllegalArgumentException("Latitude is between -90 and 90 degrees, not " + latDeg);
        }
        if (!(lonDeg >= -180 && lonDeg <= 180)) {
            throw new IllegalArgumentException("Longitude is between -180 and 180 degrees, not " + lonDeg);
        }
        if (!Double.isFinite(altM)) {
            throw new IllegalArgumentException("Altitude is finite, not " + altM);
        }
    }

    /** A point at altitude zero. */
    public static GeoPoint of(double latDeg, double lonDeg) {
        return new GeoPoint(latDeg, lonDeg, 0);
    }
}
