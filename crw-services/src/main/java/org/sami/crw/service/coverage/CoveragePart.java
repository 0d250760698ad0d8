package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.sami.crw.service.path.PathAnswer;
import org.sami.crw.service.path.PathProblem;
import org.sami.crw.service.path.ShortestPath;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * A connected part of a region: one polygon of drivable water, or several with ways between them outside forbidden areas. No way leads from one part
 * to another.
 */
final class CoveragePart {
    private static final GeometryFactory FACTORY = new GeometryFactory();

    private final Geometry region;
    private final Water water;
    private final List<Geometry> polygons = new ArrayList<>();
    private final List<Cell> cells = new ArrayList<>();
    private Optional<List<Coordinate>> tour = Optional.empty();

    private CoveragePart(Geometry region, Water water) {
        this.region = region;
        this.water = water;
    }

    /** The parts that have lanes, the largest first. */
    static List<CoveragePart> of(Geometry region, Geometry drivable, List<Cell> cells, Water water) {
        List<CoveragePart> parts = new ArrayList<>();
        for (int i = 0; i < drivable.getNumGeometries(); i++) {
            Geometry polygon = drivable.getGeometryN(i);
            List<Cell> own =
                    cells.stream().filter(cell -> cell.isIn(polygon, drivable)).toList();
            if (!own.isEmpty()) {
                GeoPoint place = Areas.point(own.get(0).start(Cell.Entry.ALL.get(0)), water.plane());
                CoveragePart part = parts.stream()
                        .filter(other -> other.isReachedFrom(place))
                        .findFirst()
                        .orElseGet(() -> {
                            parts.add(new CoveragePart(region, water));
                            return parts.get(parts.size() - 1);
                        });
                part.polygons.add(polygon);
                part.cells.addAll(own);
            }
        }
        parts.sort((one, other) -> Double.compare(other.areaM2(), one.areaM2()));
        return parts;
    }

    /** Where its first lane begins. */
    GeoPoint place() {
        return Areas.point(cells.get(0).start(Cell.Entry.ALL.get(0)), water.plane());
    }

    /** Whether a way leads to it from a place. */
    boolean isReachedFrom(GeoPoint from) {
        return way(from) instanceof PathAnswer.Way;
    }

    /** The way to it from a place, or why there is none. */
    PathAnswer way(GeoPoint from) {
        return new ShortestPath().find(new PathProblem(from, place(), water, 1));
    }

    double areaM2() {
        return polygons.stream().mapToDouble(Geometry::getArea).sum();
    }

    /** One track through all of it. */
    List<Coordinate> tour() {
        if (tour.isEmpty()) {
            tour = Optional.of(
                    CellTour.through(cells, new LaneConnections(FACTORY.buildGeometry(polygons), region, water)));
        }
        return tour.get();
    }
}
