package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.prep.PreparedGeometry;
import org.locationtech.jts.geom.prep.PreparedGeometryFactory;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;
import org.sami.crw.service.path.PathAnswer;
import org.sami.crw.service.path.PathProblem;
import org.sami.crw.service.path.ShortestPath;
import org.sami.crw.service.path.VisibilityGraph;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.Water;

/**
 * Ways between lanes. A way is straight where that stays in drivable water. Otherwise it is the first of these that exists: the shortest in drivable
 * water; the shortest in the area that keeps the boats' cross-track error from forbidden areas; a closer one; the shortest outside forbidden areas.
 */
final class LaneConnections {
    private static final GeometryFactory FACTORY = new GeometryFactory();
    /** Lanes end on the edge of what is drivable; ways between them may touch it. */
    private static final double EDGE_M = 0.02;

    /** Extra distance at the turns of ways, so that lane ends next to them stay clear. */
    private static final double TURNING_M = 0.25;

    private final Water water;
    private final Geometry region;
    private final Geometry outside;
    private final PreparedGeometry prepared;
    private Optional<VisibilityGraph> onDrivable = Optional.empty();
    private Optional<VisibilityGraph> farOffInRegion = Optional.empty();
    private Optional<VisibilityGraph> inRegion = Optional.empty();

    /**
     * Ways on the drivable part of a region.
     *
     * @param drivable polygons on the plane of the water
     * @param region the region that they are part of
     */
    LaneConnections(Geometry drivable, Geometry region, Water water) {
        this.water = water;
        this.region = region;
        outside = Water.inside(water.plane(), drivable.buffer(EDGE_M)).forbidden();
        prepared = PreparedGeometryFactory.prepare(outside);
    }

    /** The places of the shortest way with both its ends; empty where there is none. */
    Optional<List<Coordinate>> between(Coordinate from, Coordinate to) {
        if (from.equals2D(to) || !prepared.intersects(FACTORY.createLineString(new Coordinate[] {from, to}))) {
            return Optional.of(List.of(from, to));
        }
        if (onDrivable.isEmpty()) {
            onDrivable = Optional.of(new VisibilityGraph(outside, 0));
        }
        return onDrivable
                .get()
                .shortest(from, to)
                .or(() -> farOffInRegion(from, to))
                .or(() -> inRegion(from, to))
                .or(() -> throughWater(from, to));
    }

    private Optional<List<Coordinate>> farOffInRegion(Coordinate from, Coordinate to) {
        double keptM = water.margin().pathM() - TURNING_M;
        if (keptM <= water.error().steeringM()) {
            return Optional.empty();
        }
        if (farOffInRegion.isEmpty()) {
            farOffInRegion = Optional.of(inRegion(keptM));
        }
        return farOffInRegion.get().shortest(from, to);
    }

    private Optional<List<Coordinate>> inRegion(Coordinate from, Coordinate to) {
        if (inRegion.isEmpty()) {
            inRegion = Optional.of(inRegion(water.error().steeringM()));
        }
        return inRegion.get().shortest(from, to);
    }

    private VisibilityGraph inRegion(double clearanceM) {
        Geometry beyond = Water.inside(water.plane(), region).forbidden();
        return new VisibilityGraph(
                clearanceM > 0 && !water.isOpen()
                        ? OverlayNGRobust.overlay(beyond, water.forbidden().buffer(clearanceM), OverlayNG.UNION)
                        : beyond,
                0);
    }

    private Optional<List<Coordinate>> throughWater(Coordinate from, Coordinate to) {
        PathAnswer answer = new ShortestPath()
                .find(new PathProblem(Areas.point(from, water.plane()), Areas.point(to, water.plane()), water, 1));
        if (!(answer instanceof PathAnswer.Way way)) {
            return Optional.empty();
        }
        List<Coordinate> places = new ArrayList<>(List.of(from));
        way.points().forEach(point -> places.add(Areas.coordinate(point, water.plane())));
        return Optional.of(places);
    }
}
