package org.sami.crw.service.path;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/** Finds where a leg has to turn to keep clear of what is forbidden. */
public final class Detour {
    /** A leg that was planned to keep the margin may be this much nearer, in metres: it was planned on another plane. */
    private static final double SLACK_M = 0.1;

    private Detour() {}

    /**
     * The points between the two ends; none where the straight leg is clear. Where an end lies in a forbidden area, the way leaves or enters that
     * area by the shortest way. Empty where forbidden areas leave no way.
     */
    public static Optional<List<GeoPoint>> between(GeoPoint from, GeoPoint to, Water water) {
        double marginM = water.margin().pathM();
        if (isClear(from, to, water)) {
            return Optional.of(List.of());
        }
        Optional<GeoPoint> out = outside(from, water);
        Optional<GeoPoint> in = outside(to, water);
        PathProblem problem = new PathProblem(out.orElse(from), in.orElse(to), water, Math.max(marginM, SLACK_M));
        if (!(new ShortestPath().find(problem) instanceof PathAnswer.Way way)) {
            return Optional.empty();
        }
        List<GeoPoint> points =
                new ArrayList<>(way.points().subList(0, way.points().size() - 1));
        out.ifPresent(point -> points.add(0, point));
        in.ifPresent(points::add);
        return Optional.of(points);
    }

    /** A way with its turns: straight where there is no way around. */
    public static List<GeoPoint> along(GeoPoint from, List<GeoPoint> points, Optional<Water> water) {
        if (water.isEmpty()) {
            return points;
        }
        List<GeoPoint> driven = new ArrayList<>();
        GeoPoint at = from;
        for (GeoPoint point : points) {
            between(at, point, water.get()).ifPresent(driven::addAll);
            driven.add(point);
            at = point;
        }
        return driven;
    }

    /** Whether the straight leg keeps clear. */
    static boolean isClear(GeoPoint from, GeoPoint to, Water water) {
        return water.isOpen()
                || water.clearanceM(List.of(from, to)) >= leastM(water.margin().pathM());
    }

    /** What is near enough to a distance that was planned to be kept. */
    static double leastM(double distanceM) {
        return Math.max(distanceM - SLACK_M, SLACK_M);
    }

    /** The nearest place that is clear of what is forbidden, for one that is not. */
    private static Optional<GeoPoint> outside(GeoPoint end, Water water) {
        if (water.clearanceM(end) > 0) {
            return Optional.empty();
        }
        VisibilityGraph graph = VisibilityGraph.of(water, water.error().steeringM());
        return Optional.of(Areas.point(graph.nearestFree(Areas.coordinate(end, water.plane())), water.plane()));
    }
}
