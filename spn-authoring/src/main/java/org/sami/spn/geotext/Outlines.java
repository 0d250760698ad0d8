package org.sami.spn.geotext;

import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.operation.valid.IsValidOp;
import org.locationtech.jts.operation.valid.TopologyValidationError;
import org.sami.spn.value.GeoPoint;

/** Says whether points are the outline of an area, in a plane of degrees that is as narrow as the parallel of the first point. */
final class Outlines {
    private static final GeometryFactory GEOMETRY = new GeometryFactory();
    private static final double MOST_LAT_DEG = 85; // the plane has no poles

    private Outlines() {}

    /** Why points are no outline of an area, or nothing where they are. */
    static Optional<String> whyNoArea(List<GeoPoint> outline) {
        if (outline.size() < 3) {
            return Optional.of("An area has three points or more, not " + outline.size());
        }
        if (Math.abs(outline.get(0).latDeg()) > MOST_LAT_DEG) {
            return Optional.of("An area lies between the latitudes -85 and 85, not at "
                    + outline.get(0).latDeg());
        }
        TopologyValidationError error = new IsValidOp(polygon(outline)).getValidationError();
        return Optional.ofNullable(error).map(e -> "The outline of this area is not simple: " + words(e));
    }

    private static String words(TopologyValidationError error) {
        return error.getErrorType() == TopologyValidationError.SELF_INTERSECTION
                        || error.getErrorType() == TopologyValidationError.RING_SELF_INTERSECTION
                ? "it crosses or touches itself"
                : error.getMessage();
    }

    private static Polygon polygon(List<GeoPoint> outline) {
        GeoPoint origin = outline.get(0);
        double narrow = Math.cos(Math.toRadians(origin.latDeg()));
        Coordinate[] ring = new Coordinate[outline.size() + 1];
        for (int i = 0; i < ring.length; i++) {
            GeoPoint point = outline.get(i % outline.size());
            // across the date line too
            double east = Math.IEEEremainder(point.lonDeg() - origin.lonDeg(), 360) * narrow;
            ring[i] = new Coordinate(east, point.latDeg() - origin.latDeg());
        }
        return GEOMETRY.createPolygon(ring);
    }
}
