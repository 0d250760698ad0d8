package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.util.AffineTransformation;
import org.locationtech.jts.operation.buffer.BufferOp;
import org.locationtech.jts.operation.buffer.BufferParameters;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.water.Areas;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** What of a region tracks leave uncovered. */
final class UncoveredArea {
    /** Round ends are polygons inside the circle: what they cover is covered. */
    private static final int QUADRANT_SEGMENTS = 16;

    /** Where tracks are longer they are taken in pieces: one that stays at a place crosses itself as often as the square of its points. */
    private static final int PIECE = 32;

    private static final GeometryFactory FACTORY = new GeometryFactory();

    private UncoveredArea() {}

    /**
     * All points of a region that are farther from every track than a distance. Works on a plane that is turned so that most lanes
     * lie along its x-axis: boxes around slanting lanes would all overlap, and finding crossings would take their square.
     *
     * @param angleRad the direction of most lanes
     */
    static Geometry of(Geometry region, List<List<Coordinate>> tracks, double distanceM, double angleRad) {
        AffineTransformation turn = AffineTransformation.rotationInstance(-angleRad);
        Geometry rest = turn.transform(region);
        if (tracks.stream().allMatch(track -> track.size() <= PIECE)) {
            List<LineString> lanes = tracks.stream().map(UncoveredArea::line).toList();
            rest = OverlayNGRobust.overlay(
                    rest, covered(turn.transform(lines(lanes)), distanceM), OverlayNG.DIFFERENCE);
        } else {
            List<Geometry> covered = pieces(tracks).parallelStream()
                    .map(piece -> covered(turn.transform(piece), distanceM))
                    .toList();
            rest = StripDifference.of(rest, covered);
        }
        return AffineTransformation.rotationInstance(angleRad).transform(rest);
    }

    private static List<LineString> pieces(List<List<Coordinate>> tracks) {
        List<LineString> pieces = new ArrayList<>();
        for (List<Coordinate> track : tracks) {
            for (int from = 0; from + 1 < track.size(); from += PIECE) {
                pieces.add(line(track.subList(from, Math.min(track.size(), from + PIECE + 1))));
            }
        }
        return pieces;
    }

    private static Geometry covered(Geometry lines, double distanceM) {
        BufferParameters parameters = new BufferParameters(QUADRANT_SEGMENTS);
        parameters.setSimplifyFactor(0);
        return BufferOp.bufferOp(lines, distanceM, parameters);
    }

    private static LineString line(List<Coordinate> track) {
        return FACTORY.createLineString(track.toArray(Coordinate[]::new));
    }

    private static Geometry lines(List<LineString> lines) {
        return FACTORY.createMultiLineString(lines.toArray(LineString[]::new));
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
