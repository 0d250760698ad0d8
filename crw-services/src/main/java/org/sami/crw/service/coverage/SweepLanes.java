package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.util.AffineTransformation;
import org.sami.crw.service.Interruption;

/** Parallel lanes over a region, evenly spaced so that the outer ones are half a spacing from its outermost points. */
final class SweepLanes {
    /** More directions than a dozen do not find much shorter sweeps. */
    private static final int MOST_DIRECTIONS = 24;
    /** A region this part of a spacing wider needs no further lane: it is rounding. */
    private static final double SLACK = 1e-6;

    private final List<List<Lane>> rows = new ArrayList<>();
    private final double angleRad;

    private SweepLanes(double angleRad) {
        this.angleRad = angleRad;
    }

    /**
     * The sweep with the least driving among those parallel to an edge of the region's convex hull. The sweep with the fewest lines is among them,
     * because a region is narrowest across an edge of its hull. A turn counts as two spacings. Empty where no line crosses drivable water.
     *
     * @param region the region to cover
     * @param drivable the part of it in which lanes run
     */
    static Optional<SweepLanes> best(Geometry region, Geometry drivable, double spacingM) {
        Optional<SweepLanes> best = Optional.empty();
        double bestM = Double.POSITIVE_INFINITY;
        for (double angleRad : directions(region)) {
            SweepLanes sweep = along(angleRad, region, drivable, spacingM);
            double costM = sweep.lengthM() + 2 * spacingM * sweep.laneCount();
            if (sweep.laneCount() > 0 && costM < bestM * (1 - SLACK)) {
                best = Optional.of(sweep);
                bestM = costM;
            }
        }
        return best;
    }

    private static List<Double> directions(Geometry region) {
        Coordinate[] hull = region.convexHull().getCoordinates();
        List<Coordinate[]> edges = new ArrayList<>();
        for (int i = 1; i < hull.length; i++) {
            edges.add(new Coordinate[] {hull[i - 1], hull[i]});
        }
        edges.sort(Comparator.comparingDouble((Coordinate[] edge) -> -edge[0].distance(edge[1])));
        return edges.stream()
                .limit(MOST_DIRECTIONS)
                .map(edge -> Math.atan2(edge[1].y - edge[0].y, edge[1].x - edge[0].x))
                .map(angle -> angle <= -Math.PI / 2 ? angle + Math.PI : angle > Math.PI / 2 ? angle - Math.PI : angle)
                .toList();
    }

    /** The sweep in one direction, in radians from the east turning north. */
    static SweepLanes along(double angleRad, Geometry region, Geometry drivable, double spacingM) {
        SweepLanes sweep = new SweepLanes(angleRad);
        AffineTransformation turn = AffineTransformation.rotationInstance(-angleRad);
        Envelope extent = turn.transform(region).getEnvelopeInternal();
        double[][] edges = edges(turn.transform(drivable));
        int count = (int) Math.max(1, Math.ceil(extent.getHeight() / spacingM - SLACK));
        for (int row = 0; row < count; row++) {
            Interruption.check();
            double y = extent.getMinY() + extent.getHeight() * (row + 0.5) / count;
            sweep.rows.add(sweep.lanes(row, y, edges));
        }
        return sweep;
    }

    private static double[][] edges(Geometry polygons) {
        List<double[]> edges = new ArrayList<>();
        for (int i = 0; i < polygons.getNumGeometries(); i++) {
            if (polygons.getGeometryN(i) instanceof Polygon polygon) {
                addEdges(polygon.getExteriorRing().getCoordinates(), edges);
                for (int hole = 0; hole < polygon.getNumInteriorRing(); hole++) {
                    addEdges(polygon.getInteriorRingN(hole).getCoordinates(), edges);
                }
            }
        }
        return edges.toArray(double[][]::new);
    }

    private static void addEdges(Coordinate[] ring, List<double[]> edges) {
        for (int i = 1; i < ring.length; i++) {
            edges.add(new double[] {ring[i - 1].x, ring[i - 1].y, ring[i].x, ring[i].y});
        }
    }

    /** Where a line is inside: between its first and second crossing of an edge, its third and fourth and so on. */
    private List<Lane> lanes(int row, double y, double[][] edges) {
        double[] crossings = Arrays.stream(edges)
                .filter(edge -> edge[1] <= y != edge[3] <= y)
                .mapToDouble(edge -> edge[0] + (y - edge[1]) / (edge[3] - edge[1]) * (edge[2] - edge[0]))
                .sorted()
                .toArray();
        List<Lane> lanes = new ArrayList<>();
        for (int i = 0; i + 1 < crossings.length; i += 2) {
            if (crossings[i] < crossings[i + 1]) {
                lanes.add(new Lane(
                        row, crossings[i], crossings[i + 1], place(crossings[i], y), place(crossings[i + 1], y)));
            }
        }
        return lanes;
    }

    private Coordinate place(double x, double y) {
        double cos = Math.cos(angleRad);
        double sin = Math.sin(angleRad);
        return new Coordinate(x * cos - y * sin, x * sin + y * cos);
    }

    /** The direction of the lanes, in radians from the east turning north. */
    double angleRad() {
        return angleRad;
    }

    /** The lanes by their lines. */
    List<List<Lane>> rows() {
        return rows;
    }

    int laneCount() {
        return rows.stream().mapToInt(List::size).sum();
    }

    private double lengthM() {
        return rows.stream().flatMap(List::stream).mapToDouble(Lane::lengthM).sum();
    }
}
