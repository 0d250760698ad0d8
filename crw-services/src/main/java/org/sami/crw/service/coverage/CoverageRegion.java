package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.locationtech.jts.algorithm.MinimumDiameter;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.SafetyMargin;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** What of an area is to be covered and how lanes lie in it. */
final class CoverageRegion {
    private static final double MOST_MARGIN_M = 0.5;
    private static final double MARGIN_OF_SPACING = 1.0 / 20;
    /** A piece of rest with less than this part of a square spacing is not worth a lane. */
    private static final double LEAST_REST = 0.25;

    /** The same where more than {@link #MOST_REST} of the region would stay uncovered: a boat drives there for it alone. */
    private static final double SMALLEST_REST = 1.0 / 1024;

    private static final double MOST_REST = 0.002;

    /** What then is aimed at: boats end lanes a little before their ends, and leave more of areas with many short ones. */
    private static final double AIMED_REST = 0.001;

    private final LocalPlane plane;
    private final double spacingM;
    private final Water water;
    private final Geometry region;
    /** The region without its rim: where lanes end. */
    private final Geometry drivable;

    private final SweepLanes sweep;

    /** Refuses an area that is no simple polygon, or of which nothing may be entered. */
    CoverageRegion(CoverageProblem problem) {
        GeoPoint origin = problem.area().outline().get(0);
        plane = new LocalPlane(origin);
        spacingM = problem.spacingM();
        List<GeoArea> avoid = new ArrayList<>(problem.avoid());
        problem.area().holes().forEach(hole -> avoid.add(new GeoArea(hole, List.of())));
        water = Water.of(origin, avoid, problem.within()).drivenWith(problem.error());
        region = AreaCoverage.region(problem.area(), problem.avoid(), problem.within(), plane);
        if (region.isEmpty()) {
            throw new IllegalArgumentException("Nothing of the area may be entered");
        }
        double narrowestM = new MinimumDiameter(region).getLength();
        Geometry inside = region.buffer(-Math.min(MOST_MARGIN_M, MARGIN_OF_SPACING * Math.min(spacingM, narrowestM)));
        Geometry wide = offForbidden(inside, new SafetyMargin(problem.error()).pathM());
        drivable = wide.isEmpty() ? offForbidden(inside, problem.error().steeringM()) : wide;
        sweep = SweepLanes.best(region, drivable, spacingM)
                .orElseThrow(() -> new IllegalArgumentException("The area is too narrow to be driven in"));
    }

    private Geometry offForbidden(Geometry inside, double marginM) {
        return marginM > 0 && !water.isOpen()
                ? OverlayNGRobust.overlay(inside, water.forbidden().buffer(marginM), OverlayNG.DIFFERENCE)
                : inside;
    }

    /**
     * What boats can drive on in one go: for each part of the region that ways connect, one track through it. Where tracks leave more than a little of
     * what can be covered, smaller pieces get lanes, too.
     */
    List<CoveragePart> parts() {
        List<Cell> cells = new ArrayList<>(Cell.of(sweep, drivable));
        List<List<Coordinate>> lanes =
                cells.stream().flatMap(cell -> cell.lanes().stream()).toList();
        cells.addAll(cellsFor(UncoveredArea.of(region, lanes, spacingM / 2, sweep.angleRad()), LEAST_REST));
        List<CoveragePart> parts = CoveragePart.of(region, drivable, cells, water);
        double mostM2 = AIMED_REST * region.getArea();
        if (coverable(parts).getArea() <= MOST_REST * region.getArea()) {
            return parts;
        }
        for (double leastRest = LEAST_REST / 4; leastRest >= SMALLEST_REST && !parts.isEmpty(); leastRest /= 4) {
            List<Geometry> rest = largestFirst(coverable(parts));
            double restM2 = rest.stream().mapToDouble(Geometry::getArea).sum();
            boolean isMore = false;
            for (int i = 0; i < rest.size() && restM2 > mostM2; i++) {
                isMore |= cells.addAll(cellsFor(rest.get(i), leastRest));
                restM2 -= rest.get(i).getArea();
            }
            parts = isMore ? CoveragePart.of(region, drivable, cells, water) : parts;
        }
        return parts;
    }

    private static List<Geometry> largestFirst(Geometry geometry) {
        List<Geometry> pieces = new ArrayList<>();
        for (int i = 0; i < geometry.getNumGeometries(); i++) {
            pieces.add(geometry.getGeometryN(i));
        }
        pieces.sort(Comparator.comparingDouble(piece -> -piece.getArea()));
        return pieces;
    }

    /** What the tracks of parts leave uncovered, although boats can come near enough. */
    private Geometry coverable(List<CoveragePart> parts) {
        Geometry rest = uncovered(parts.stream().map(CoveragePart::tour).toList());
        return rest.isEmpty()
                ? rest
                : OverlayNGRobust.overlay(rest, drivable.buffer(spacingM / 2), OverlayNG.INTERSECTION);
    }

    /** Strips left over next to holes and bays get their own lanes: lane positions ignore such outlines. */
    private List<Cell> cellsFor(Geometry rest, double leastRest) {
        List<Cell> more = new ArrayList<>();
        for (int i = 0; i < rest.getNumGeometries(); i++) {
            Geometry piece = rest.getGeometryN(i);
            if (piece.getArea() >= leastRest * spacingM * spacingM) {
                Geometry within = OverlayNGRobust.overlay(piece, drivable, OverlayNG.INTERSECTION);
                SweepLanes.best(piece, within, spacingM)
                        .map(lanesOfPiece -> Cell.of(lanesOfPiece, within))
                        .ifPresent(more::addAll);
            }
        }
        return more;
    }

    /** What shares leave uncovered. */
    Geometry rest(List<CoverageShare> shares) {
        List<List<Coordinate>> tracks = new ArrayList<>();
        shares.forEach(share -> tracks.add(share.track().stream()
                .map(point -> Areas.coordinate(point, plane))
                .toList()));
        return uncovered(tracks);
    }

    private Geometry uncovered(List<List<Coordinate>> tracks) {
        return tracks.isEmpty() ? region : UncoveredArea.of(region, tracks, spacingM / 2, sweep.angleRad());
    }

    /** Where boats may go on their way to the area. */
    Water water() {
        return water;
    }

    LocalPlane plane() {
        return plane;
    }

    double areaM2() {
        return region.getArea();
    }
}
