package org.sami.crw.service.water;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.operation.valid.IsValidOp;
import org.locationtech.jts.operation.valid.TopologyValidationError;
import org.sami.crw.service.LocalPlane;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Areas as polygons on a plane. */
public final class Areas {
    private static final GeometryFactory FACTORY = new GeometryFactory();

    private Areas() {}

    /**
     * The polygon of an area.
     *
     * @param what the area's name in messages
     * @throws IllegalArgumentException for an area that is no simple polygon (it crosses itself, has a hole outside, or has no extent), with the
     *     point where
     */
    public static Polygon polygon(GeoArea area, LocalPlane plane, String what) {
        LinearRing outline = ring(area.outline(), plane, what);
        LinearRing[] holes =
                area.holes().stream().map(hole -> ring(hole, plane, what)).toArray(LinearRing[]::new);
        Polygon polygon = FACTORY.createPolygon(outline, holes);
        TopologyValidationError error = new IsValidOp(polygon).getValidationError();
        if (error != null) {
            throw new IllegalArgumentException(what + " is no simple polygon: " + words(error, plane));
        }
        return polygon;
    }

    private static LinearRing ring(List<GeoPoint> points, LocalPlane plane, String what) {
        List<Coordinate> coordinates = new ArrayList<>();
        for (GeoPoint point : points) {
            Coordinate next = coordinate(point, plane);
            if (coordinates.isEmpty()
                    || !coordinates.get(coordinates.size() - 1).equals2D(next)) {
                coordinates.add(next);
            }
        }
        if (coordinates.size() > 1 && coordinates.get(0).equals2D(coordinates.get(coordinates.size() - 1))) {
            coordinates.remove(coordinates.size() - 1);
        }
        if (coordinates.size() < 3) {
            throw new IllegalArgumentException(
                    what + " is no simple polygon: one of its rings has fewer than three different points");
        }
        coordinates.add(coordinates.get(0).copy());
        return FACTORY.createLinearRing(coordinates.toArray(Coordinate[]::new));
    }

    private static String words(TopologyValidationError error, LocalPlane plane) {
        GeoPoint at = plane.point(error.getCoordinate().x, error.getCoordinate().y);
        String fault = switch (error.getErrorType()) {
            case TopologyValidationError.SELF_INTERSECTION, TopologyValidationError.RING_SELF_INTERSECTION ->
                "it crosses or touches itself";
            case TopologyValidationError.HOLE_OUTSIDE_SHELL -> "a hole lies outside";
            case TopologyValidationError.NESTED_HOLES -> "one hole lies in another";
            case TopologyValidationError.DISCONNECTED_INTERIOR -> "its holes cut it apart";
            default -> error.getMessage().toLowerCase(Locale.ROOT);
        };
        return String.format(Locale.ROOT, "%s at %.6f, %.6f", fault, at.latDeg(), at.lonDeg());
    }

    /** A point on the plane. */
    public static Coordinate coordinate(GeoPoint point, LocalPlane plane) {
        return new Coordinate(plane.x(point), plane.y(point));
    }

    /** A point of the surface. */
    public static GeoPoint point(Coordinate coordinate, LocalPlane plane) {
        return plane.point(coordinate.x, coordinate.y);
    }
}
