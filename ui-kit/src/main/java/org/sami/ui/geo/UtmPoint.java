package org.sami.ui.geo;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.locationtech.proj4j.BasicCoordinateTransform;
import org.locationtech.proj4j.CRSFactory;
import org.locationtech.proj4j.CoordinateReferenceSystem;
import org.locationtech.proj4j.Proj4jException;
import org.locationtech.proj4j.ProjCoordinate;
import org.sami.spn.value.GeoPoint;

/**
 * A point on the Universal Transverse Mercator grid (WGS 84).
 *
 * @param zone 1 to 60
 * @param band letter of the latitude's band, C to X without I and O; those from N on lie in the north
 */
record UtmPoint(int zone, char band, double eastingM, double northingM) {
    private static final String BANDS = "CDEFGHJKLMNPQRSTUVWX";
    private static final double SOUTH_END_DEG = -80;
    private static final double NORTH_END_DEG = 84;
    private static final double BAND_DEG = 8;
    private static final double ZONE_DEG = 6;
    private static final CRSFactory SYSTEMS = new CRSFactory();
    private static final CoordinateReferenceSystem DEGREES =
            SYSTEMS.createFromParameters("degrees", "+proj=longlat +datum=WGS84 +no_defs");
    private static final Map<String, CoordinateReferenceSystem> GRIDS = new ConcurrentHashMap<>();

    UtmPoint {
        if (zone < 1 || zone > 60 || BANDS.indexOf(band) < 0) {
            throw new IllegalArgumentException("There is no UTM zone " + zone + band);
        }
    }

    /** Where a point lies on the grid; nowhere beyond 80° south and 84° north. */
    static Optional<UtmPoint> of(GeoPoint point) {
        if (point.latDeg() < SOUTH_END_DEG || point.latDeg() > NORTH_END_DEG) {
            return Optional.empty();
        }
        char band = bandOf(point.latDeg());
        int zone = zoneOf(point, band);
        ProjCoordinate metres = new BasicCoordinateTransform(DEGREES, grid(zone, band))
                .transform(new ProjCoordinate(point.lonDeg(), point.latDeg()), new ProjCoordinate());
        return Optional.of(new UtmPoint(zone, band, metres.x, metres.y));
    }

    private static char bandOf(double latDeg) {
        int index = (int) Math.floor((latDeg - SOUTH_END_DEG) / BAND_DEG);
        return BANDS.charAt(Math.min(index, BANDS.length() - 1));
    }

    /** The zone of six degrees, but for the wider ones at Norway's coast and around Svalbard. */
    private static int zoneOf(GeoPoint point, char band) {
        double lonDeg = point.lonDeg();
        if (band == 'V' && lonDeg >= 3 && lonDeg < 12) {
            return 32;
        }
        if (band == 'X' && lonDeg >= 0 && lonDeg < 42) {
            return 31 + 2 * (int) Math.floor((lonDeg + 3) / (2 * ZONE_DEG));
        }
        return Math.min(60, 1 + (int) Math.floor((lonDeg + 180) / ZONE_DEG));
    }

    private static CoordinateReferenceSystem grid(int zone, char band) {
        String definition =
                "+proj=utm +zone=" + zone + (band < 'N' ? " +south" : "") + " +datum=WGS84 +units=m +no_defs";
        return GRIDS.computeIfAbsent(definition, text -> SYSTEMS.createFromParameters(text, text));
    }

    /** Its latitude and longitude; none where the zone has no such point. */
    Optional<GeoPoint> point() {
        try {
            ProjCoordinate at = new BasicCoordinateTransform(grid(zone, band), DEGREES)
                    .transform(new ProjCoordinate(eastingM, northingM), new ProjCoordinate());
            return Optional.of(GeoPoint.of(at.y, at.x));
        } catch (Proj4jException | IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    /** Whether a latitude lies in the band, or so near that rounding to a metre may have brought it there. */
    boolean isInBand(double latDeg) {
        double slackDeg = 1e-4;
        double south = SOUTH_END_DEG + BAND_DEG * BANDS.indexOf(band);
        double north = band == 'X' ? NORTH_END_DEG : south + BAND_DEG;
        return latDeg >= south - slackDeg && latDeg <= north + slackDeg;
    }

    /** {@code 32T 633842 5062301}. */
    String utm() {
        return String.format(Locale.ROOT, "%d%s %06d %07d", zone, band, Math.round(eastingM), Math.round(northingM));
    }
}
