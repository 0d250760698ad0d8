package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.operation.buffer.BufferOp;
import org.locationtech.jts.operation.buffer.BufferParameters;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.water.Areas;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** What of a region tracks leave uncovered. */
final class Rest {
    /** Round ends are polygons inside the circle: what they cover is covered. */
    private static final int QUADRANT_SEGMENTS = 16;

    private static final GeometryFactory FACTORY = new GeometryFactory();

    private Rest() {}

    /** All points of a region that are farther from every track than a distance. */
    static Geometry of(Geometry region, List<List<Coordinate>> tracks, double distanceM) {
        BufferParameters parameters = new BufferParameters(QUADRANT_SEGMENTS);
        parameters.setSimplifyFactor(0);
        LineString[] lines = tracks.stream()
                .map(track -> FACTORY.createLineString(track.toArray(Coordinate[]::new)))
                .toArray(LineString[]::new);
        Geometry covered = BufferOp.bufferOp(FACTORY.createMultiLineString(lines), distanceM, parameters);
        return OverlayNGRobust.overlay(region, covered, OverlayNG.DIFFERENCE);
    }

    /** The polygons of a geometry as areas. */
    static List<GeoArea> areas(Geometry geometry, LocalPlane plane) {
        List<GeoArea> areas = new ArrayList<>();
        for (int i = 0; i < geometry.getNumGeometries(); i++) {
            if (geometry.getGeometryN(i) instanceof Polygon polygon && !polygon.isEmpty()) {
                List<List<GeoPoint>> holes = new ArrayList<>();
                for (int hole = 0; hole < polygon.getNumInteriorRing(); hole++) {
                    holes.add(points(polygon.getInteriorRingN(hole), plane));
                }
                areas.add(new GeoArea(points(polygon.getExteriorRing(), plane), holes));
            }
        }
        return areas;
    }

    private static List<GeoPoint> points(LinearRing ring, LocalPlane plane) {
        List<GeoPoint> points = new ArrayList<>();
        Coordinate[] coordinates = ring.getCoordinates();
        for (int i = 0; i + 1 < coordinates.length; i++) {
            points.add(Areas.point(coordinates[i], plane));
        }
        return points;
    }
}
