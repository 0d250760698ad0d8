package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.locationtech.jts.algorithm.MinimumDiameter;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.allocation.LeastSumAssignment;
import org.sami.crw.service.path.PathAnswer;
import org.sami.crw.service.path.PathProblem;
import org.sami.crw.service.path.ShortestPath;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * To and fro in lanes, as one mows a lawn (thesis 6.2). One tour through the whole area is cut into pieces of equal length, one for
 * each boat, so no boat's share lies in another's. The pieces are given out so that the boats' ways to them are least in sum, and
 * each is driven from its nearer end.
 *
 * <p>Tracks never leave the area and enter none of its holes; where the area is in parts, boats cross from one to the next through
 * what is not forbidden. Lanes end a little before the area's edge, half a metre at most.
 */
public final class LawnMower implements CoverageAlgorithm {
    private static final double MOST_MARGIN_M = 0.5;
    /** A piece of rest with less than this part of a square spacing is not worth a lane. */
    private static final double LEAST_REST = 0.25;

    private static final double MARGIN_OF_SPACING = 1.0 / 20;

    @Override
    public Coverage cover(CoverageProblem problem) {
        GeoPoint origin = problem.area().outline().get(0);
        LocalPlane plane = new LocalPlane(origin);
        Polygon area = Areas.polygon(problem.area(), plane, "The area");
        List<GeoArea> avoid = new ArrayList<>(problem.avoid());
        problem.area().holes().forEach(hole -> avoid.add(new GeoArea(hole, List.of())));
        Water water = Water.of(origin, avoid, problem.within());
        Geometry region = Water.of(origin, problem.avoid(), problem.within()).allowed(area);
        if (region.isEmpty()) {
            throw new IllegalArgumentException("Nothing of the area may be entered");
        }
        List<Coordinate> tour = tour(region, water, plane, problem.spacingM());
        Map<String, String> noWay = new LinkedHashMap<>();
        Map<String, CoverageShare> shares = shares(problem, tour, water, noWay);
        List<List<Coordinate>> tracks = new ArrayList<>();
        shares.values()
                .forEach(share -> tracks.add(share.track().stream()
                        .map(point -> Areas.coordinate(point, plane))
                        .toList()));
        Geometry rest = tracks.isEmpty() ? region : Rest.of(region, tracks, problem.spacingM() / 2);
        return new Coverage(shares, noWay, region.getArea(), rest.getArea(), Rest.areas(rest, plane));
    }

    private static List<Coordinate> tour(Geometry region, Water water, LocalPlane plane, double spacingM) {
        double narrowestM = new MinimumDiameter(region).getLength();
        double marginM = Math.min(MOST_MARGIN_M, MARGIN_OF_SPACING * Math.min(spacingM, narrowestM));
        Geometry drivable = region.buffer(-marginM);
        List<Cell> cells = new ArrayList<>(cells(region, drivable, spacingM));
        if (cells.isEmpty()) {
            throw new IllegalArgumentException("The area is too narrow to be driven in");
        }
        cells.addAll(cellsForRest(region, drivable, spacingM, cells));
        Geometry forbidden =
                region instanceof Polygon ? Water.inside(plane, region).forbidden() : water.forbidden();
        return Tour.through(cells, new Travel(forbidden));
    }

    private static List<Cell> cells(Geometry region, Geometry drivable, double spacingM) {
        return Sweep.best(region, drivable, spacingM).map(Cell::of).orElse(List.of());
    }

    /** Strips that are left beside holes and bays, as these do not care where lanes lie, get lanes of their own. */
    private static List<Cell> cellsForRest(Geometry region, Geometry drivable, double spacingM, List<Cell> cells) {
        List<List<Coordinate>> lanes =
                cells.stream().flatMap(cell -> cell.lanes().stream()).toList();
        Geometry rest = Rest.of(region, lanes, spacingM / 2);
        List<Cell> more = new ArrayList<>();
        for (int i = 0; i < rest.getNumGeometries(); i++) {
            Geometry piece = rest.getGeometryN(i);
            if (piece.getArea() >= LEAST_REST * spacingM * spacingM) {
                Geometry within = OverlayNGRobust.overlay(piece, drivable, OverlayNG.INTERSECTION);
                more.addAll(cells(piece, within, spacingM));
            }
        }
        return more;
    }

    private static Map<String, CoverageShare> shares(
            CoverageProblem problem, List<Coordinate> tour, Water water, Map<String, String> noWay) {
        Map<String, CoverageShare> shares = new LinkedHashMap<>();
        List<List<Coordinate>> pieces = TrackPieces.of(tour, problem.boats().size());
        List<Optional<GeoPoint>> boats = List.copyOf(problem.boats().values());
        double[][] costs = new double[boats.size()][pieces.size()];
        for (int boat = 0; boat < boats.size(); boat++) {
            for (int piece = 0; piece < pieces.size(); piece++) {
                costs[boat][piece] = approachM(boats.get(boat), pieces.get(piece), water);
            }
        }
        int[] pieceOf = LeastSumAssignment.of(costs);
        int boat = 0;
        for (Map.Entry<String, Optional<GeoPoint>> entry : problem.boats().entrySet()) {
            List<Coordinate> piece = pieces.get(pieceOf[boat++]);
            List<GeoPoint> track = driven(entry.getValue(), piece, water);
            PathAnswer approach = approach(entry.getValue(), track.get(0), water);
            if (approach instanceof PathAnswer.NoWay none) {
                noWay.put(entry.getKey(), none.reason());
                return problem.boats().size() == 1
                        ? Map.of()
                        : shares(problem.without(entry.getKey()), tour, water, noWay);
            }
            List<GeoPoint> way = ((PathAnswer.Way) approach).points();
            shares.put(
                    entry.getKey(),
                    new CoverageShare(way.subList(0, way.size() - 1), track, TrackPieces.lengthM(piece)));
        }
        return shares;
    }

    private static double approachM(Optional<GeoPoint> boat, List<Coordinate> piece, Water water) {
        return boat.map(at -> Areas.coordinate(at, water.plane()))
                .map(at -> Math.min(at.distance(piece.get(0)), at.distance(piece.get(piece.size() - 1))))
                .orElse(0.0);
    }

    private static List<GeoPoint> driven(Optional<GeoPoint> boat, List<Coordinate> piece, Water water) {
        List<GeoPoint> track = new ArrayList<>();
        piece.forEach(place -> track.add(Areas.point(place, water.plane())));
        boat.map(at -> Areas.coordinate(at, water.plane())).ifPresent(at -> {
            if (at.distance(piece.get(piece.size() - 1)) < at.distance(piece.get(0))) {
                Collections.reverse(track);
            }
        });
        return track;
    }

    private static PathAnswer approach(Optional<GeoPoint> boat, GeoPoint to, Water water) {
        GeoPoint from = boat.orElse(to);
        return new ShortestPath().find(new PathProblem(from, to, water, 1));
    }
}
