package org.sami.crw.service.path;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.operation.distance.DistanceOp;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * The way of a boat out of an area: along the path that it still has to drive, as far as that leads out, and otherwise across the nearest edge
 * (thesis 7.1.1, Figure 7.4).
 */
public final class WayOut {
    /** How far beyond the edge the way ends, in metres: a boat that arrives within its radius of the end is outside. */
    private static final double BEYOND_M = 5;

    private static final double STEP_M = 0.5;
    private static final double ROUNDING_M = 0.01;
    private static final GeometryFactory FACTORY = new GeometryFactory();

    private final LocalPlane plane;
    private final Polygon area;

    /**
     * Ways out of an area.
     *
     * @throws IllegalArgumentException for an area that is no simple polygon
     */
    public WayOut(GeoArea area) {
        plane = new LocalPlane(area.outline().get(0));
        this.area = Areas.polygon(area, plane, "The area");
    }

    /** Whether a point is in the area; its edge belongs to it. */
    public boolean isInside(GeoPoint point) {
        return distanceM(Areas.coordinate(point, plane)) == 0;
    }

    /**
     * The points to drive from a point in the area until outside: those of a path up to where it is out of the area, and that place.
     *
     * @param path points that are still to be driven to, in order
     * @return empty where the path does not lead out
     */
    public Optional<List<GeoPoint>> along(GeoPoint from, List<GeoPoint> path) {
        List<GeoPoint> way = new ArrayList<>();
        Coordinate last = Areas.coordinate(from, plane);
        for (GeoPoint point : path) {
            Coordinate next = Areas.coordinate(point, plane);
            Optional<Coordinate> out = firstOutside(last, next);
            if (out.isPresent()) {
                way.add(Areas.point(out.get(), plane));
                return Optional.of(way);
            }
            way.add(point);
            last = next;
        }
        return Optional.empty();
    }

    /**
     * The nearest place outside the area, and outside of what a water forbids where it leaves one.
     *
     * @param water where the boat may go
     */
    public GeoPoint acrossNearestEdge(GeoPoint from, Optional<Water> water) {
        Geometry rim = area.buffer(BEYOND_M).getBoundary();
        Coordinate place = Areas.coordinate(from, plane);
        GeoPoint nearest = nearest(rim, place);
        if (water.isEmpty() || water.get().allows(List.of(nearest))) {
            return nearest;
        }
        List<Coordinate> free = new ArrayList<>();
        double lengthM = rim.getLength();
        Coordinate[] corners = rim.getCoordinates();
        for (int i = 1; i < corners.length && lengthM > 0; i++) {
            for (double part = 0; part < 1; part += STEP_M / Math.max(STEP_M, corners[i - 1].distance(corners[i]))) {
                Coordinate one = between(corners[i - 1], corners[i], part);
                if (rim.distance(FACTORY.createPoint(one)) < ROUNDING_M
                        && water.get().allows(List.of(Areas.point(one, plane)))) {
                    free.add(one);
                }
            }
        }
        return free.isEmpty()
                ? nearest
                : nearest(FACTORY.createMultiPointFromCoords(free.toArray(Coordinate[]::new)), place);
    }

    private GeoPoint nearest(Geometry places, Coordinate from) {
        return Areas.point(DistanceOp.nearestPoints(places, FACTORY.createPoint(from))[0], plane);
    }

    private Optional<Coordinate> firstOutside(Coordinate from, Coordinate to) {
        int steps = (int) Math.ceil(from.distance(to) / STEP_M);
        for (int step = 1; step <= steps; step++) {
            Coordinate place = between(from, to, (double) step / steps);
            if (distanceM(place) >= BEYOND_M) {
                return Optional.of(place);
            }
        }
        return Optional.empty();
    }

    private double distanceM(Coordinate place) {
        return area.distance(FACTORY.createPoint(place));
    }

    private static Coordinate between(Coordinate from, Coordinate to, double part) {
        return new Coordinate(from.x + part * (to.x - from.x), from.y + part * (to.y - from.y));
    }
}
