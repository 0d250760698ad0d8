package org.sami.crw.log;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.locationtech.proj4j.BasicCoordinateTransform;
import org.locationtech.proj4j.CRSFactory;
import org.locationtech.proj4j.CoordinateReferenceSystem;
import org.locationtech.proj4j.Proj4jException;
import org.locationtech.proj4j.ProjCoordinate;
import org.sami.spn.value.GeoPoint;

/**
 * From the metres of the Universal Transverse Mercator grid to latitude and longitude (WGS 84). Zones are written as the
 * boats write them: {@code 17North}, or with the letter of the latitude's band, {@code 17T}.
 */
final class UtmGrid {
    private static final Pattern ZONE = Pattern.compile("(\\d{1,2})\\s*(North|South|[C-HJ-NP-X])");
    private static final double LEAST_EASTING_M = 100_000;
    private static final double MOST_EASTING_M = 900_000;
    private static final double MOST_NORTHING_M = 10_000_000;

    private final CRSFactory systems = new CRSFactory();
    private final CoordinateReferenceSystem degrees =
            systems.createFromParameters("degrees", "+proj=longlat +datum=WGS84 +no_defs");
    private final Map<String, Optional<BasicCoordinateTransform>> zones = new HashMap<>();

    /**
     * The point at so many metres in a zone, at altitude zero.
     *
     * @throws BadLineException if there is no such zone, or no such point in one
     */
    GeoPoint point(String zone, double eastingM, double northingM) throws BadLineException {
        boolean inZone = eastingM >= LEAST_EASTING_M
                && eastingM <= MOST_EASTING_M
                && northingM >= 0
                && northingM <= MOST_NORTHING_M;
        if (!inZone) {
            throw bad("no zone of the UTM grid has a point " + eastingM + ", " + northingM);
        }
        BasicCoordinateTransform transform = zones.computeIfAbsent(zone, this::transform)
                .orElseThrow(() -> bad("there is no zone '" + zone + "' of the UTM grid"));
        try {
            ProjCoordinate at = transform.transform(new ProjCoordinate(eastingM, northingM), new ProjCoordinate());
            return GeoPoint.of(at.y, at.x);
        } catch (Proj4jException | IllegalArgumentException e) {
            throw bad("zone " + zone + " of the UTM grid has no point " + eastingM + ", " + northingM);
        }
    }

    private Optional<BasicCoordinateTransform> transform(String zone) {
        Matcher parts = ZONE.matcher(zone);
        if (!parts.matches()) {
            return Optional.empty();
        }
        int number = Integer.parseInt(parts.group(1));
        if (number < 1 || number > 60) {
            return Optional.empty();
        }
        String half = parts.group(2);
        boolean south = half.equals("South") || (half.length() == 1 && half.charAt(0) < 'N');
        CoordinateReferenceSystem grid = systems.createFromParameters(
                zone, "+proj=utm +zone=" + number + (south ? " +south" : "") + " +datum=WGS84 +units=m +no_defs");
        return Optional.of(new BasicCoordinateTransform(grid, degrees));
    }

    private static BadLineException bad(String message) {
        return new BadLineException(LineFault.BAD_CONTENT, message);
    }
}
