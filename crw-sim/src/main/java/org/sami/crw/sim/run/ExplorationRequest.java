package org.sami.crw.sim.run;

import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.util.GeometryFixer;
import org.locationtech.jts.operation.buffer.BufferOp;
import org.locationtech.jts.operation.buffer.BufferParameters;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;
import org.sami.boat.server.LocalFrame;
import org.sami.crw.sim.report.BoatResult;
import org.sami.crw.sim.report.Exploration;
import org.sami.crw.sim.report.MapArea;
import org.sami.crw.sim.report.MapPoint;
import org.sami.crw.sim.report.TrackPoint;

/**
 * An area that boats were to explore from a time on. What of it was covered is seen by the tracks, not by what was planned: a point is
 * covered when any boat came as near as half the spacing since. On the plane of the area's centre.
 *
 * @param avoided what of it was not to be entered
 */
record ExplorationRequest(long askedAtMillis, double spacingM, MapArea area, List<MapArea> avoided) {
    private static final GeometryFactory FACTORY = new GeometryFactory();

    /** Round ends are polygons inside the circle: what they cover is covered. */
    private static final int QUADRANT_SEGMENTS = 16;

    /** Bends of a track that are flatter than this do not matter beside a spacing, in metres. */
    private static final double FLAT_M = 0.02;

    /** Smaller pieces are left out of the map; their sum is not. */
    private static final double CRUMB_M2 = 1;

    /** What became of it. */
    Exploration result(List<BoatResult> boats, LocalFrame plane) {
        Geometry toDo = polygon(area);
        for (MapArea hole : avoided) {
            toDo = OverlayNGRobust.overlay(toDo, polygon(hole), OverlayNG.DIFFERENCE);
        }
        Geometry left = OverlayNGRobust.overlay(toDo, covered(boats), OverlayNG.DIFFERENCE);
        return new Exploration(askedAtMillis, spacingM, toDo.getArea(), left.getArea(), pieces(left, plane));
    }

    private Geometry covered(List<BoatResult> boats) {
        BufferParameters parameters = new BufferParameters(QUADRANT_SEGMENTS);
        parameters.setSimplifyFactor(0);
        LineString[] ways = boats.stream()
                .map(this::way)
                .filter(way -> way.length > 1)
                .map(FACTORY::createLineString)
                .toArray(LineString[]::new);
        return BufferOp.bufferOp(FACTORY.createMultiLineString(ways), spacingM / 2, parameters);
    }

    private Coordinate[] way(BoatResult boat) {
        List<TrackPoint> since = boat.track().stream()
                .filter(point -> point.atMillis() >= askedAtMillis)
                .toList();
        return TrackThinning.within(FLAT_M, since).stream()
                .map(point -> new Coordinate(point.eastM(), point.northM()))
                .toArray(Coordinate[]::new);
    }

    /** What crosses itself becomes what it can be taken for: boats did not explore it either. */
    private static Geometry polygon(MapArea area) {
        return GeometryFixer.fix(FACTORY.createPolygon(
                ring(area.outline()),
                area.holes().stream().map(ExplorationRequest::ring).toArray(LinearRing[]::new)));
    }

    private static LinearRing ring(List<MapPoint> points) {
        List<Coordinate> coordinates = new ArrayList<>();
        points.forEach(point -> coordinates.add(new Coordinate(point.eastM(), point.northM())));
        coordinates.add(coordinates.get(0).copy());
        return FACTORY.createLinearRing(coordinates.toArray(Coordinate[]::new));
    }

    private static List<MapArea> pieces(Geometry geometry, LocalFrame plane) {
        List<MapArea> pieces = new ArrayList<>();
        for (int i = 0; i < geometry.getNumGeometries(); i++) {
            if (geometry.getGeometryN(i) instanceof Polygon polygon && polygon.getArea() >= CRUMB_M2) {
                List<List<MapPoint>> holes = new ArrayList<>();
                for (int hole = 0; hole < polygon.getNumInteriorRing(); hole++) {
                    holes.add(points(polygon.getInteriorRingN(hole), plane));
                }
                pieces.add(new MapArea(MapArea.Kind.UNCOVERED, points(polygon.getExteriorRing(), plane), holes));
            }
        }
        return pieces;
    }

    private static List<MapPoint> points(LinearRing ring, LocalFrame plane) {
        List<MapPoint> points = new ArrayList<>();
        Coordinate[] coordinates = ring.getCoordinates();
        for (int i = 0; i + 1 < coordinates.length; i++) { // the last is the first
            double eastM = coordinates[i].x;
            double northM = coordinates[i].y;
            points.add(new MapPoint(plane.latDeg(eastM, northM), plane.lonDeg(eastM, northM), eastM, northM));
        }
        return points;
    }
}
