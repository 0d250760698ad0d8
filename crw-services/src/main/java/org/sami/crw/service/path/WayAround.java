package org.sami.crw.service.path;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.operation.distance.IndexedFacetDistance;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * Finds the shortest way for a problem that keeps a clearance where there is room. In gaps that are too narrow it keeps as much of it as
 * they allow, in its middle, and never less than the boats' steering needs; a gap is taken where keeping all of the clearance costs more than the
 * problem's detour.
 */
final class WayAround {
    /** What of the clearance is tried in gaps, the most first. */
    private static final double[] PARTS = {0.9, 0.75, 0.5, 0.25, 0.1, 0};

    /** A gap up to so many times as wide as boats' steering needs is passed in its middle. */
    private static final double NARROW = 2;

    private static final double ROUNDING_M = 0.01;

    private final PathProblem problem;
    private final Water water;
    private final String method;
    private long tested;

    WayAround(PathProblem problem, String method) {
        this.problem = problem;
        this.method = method;
        water = problem.water();
    }

    PathAnswer find(double clearanceM) {
        if (water.isOpen()) {
            return way(List.of(problem.to()), clearanceM);
        }
        Optional<String> forbidden = forbiddenEnd();
        if (forbidden.isPresent()) {
            return new PathAnswer.NoWay(forbidden.get(), tested);
        }
        double leastM = water.error().steeringM();
        Optional<Route> shortest = route(VisibilityGraph.of(water, leastM));
        if (shortest.isEmpty()) {
            return new PathAnswer.NoWay("what is forbidden lies all the way between start and goal" + room(), tested);
        }
        double shortestM = shortest.get().lengthM();
        double longestM = problem.detour() * shortestM;
        if (clearanceM > leastM) {
            Optional<Route> kept = within(longestM, route(VisibilityGraph.of(water, clearanceM)));
            for (int i = 0; kept.isEmpty() && i < PARTS.length; i++) {
                double gapM = Math.max(leastM, PARTS[i] * clearanceM);
                kept = within(longestM, route(VisibilityGraph.withGaps(water, clearanceM, gapM)));
            }
            if (kept.isPresent()) {
                Route centred = within(longestM, kept.map(route -> centred(route, clearanceM)))
                        .orElse(kept.get());
                return way(centred.points(), clearanceM).than(shortestM);
            }
        }
        return way(centred(shortest.get(), leastM).points(), leastM);
    }

    private static Optional<Route> within(double longestM, Optional<Route> route) {
        return route.filter(found -> found.lengthM() <= longestM);
    }

    /** A route in the middle of narrow gaps; the same where that came nearer to what is forbidden. */
    private Route centred(Route route, double wantedM) {
        double narrowM = Math.max(wantedM, NARROW * water.error().steeringM());
        double hereM = water.clearanceM(route.whole());
        if (hereM >= narrowM) {
            return route;
        }
        IndexedFacetDistance edges = water.derived(
                CentredGaps.class, IndexedFacetDistance.class, () -> new IndexedFacetDistance(water.forbidden()));
        Route centred = route.between(new CentredGaps(edges, wantedM, narrowM).centred(route.between()));
        return water.clearanceM(centred.whole()) >= hereM - ROUNDING_M ? centred : route;
    }

    private Optional<Route> route(VisibilityGraph graph) {
        List<Coordinate> out = leave(problem.from(), graph);
        List<Coordinate> in = leave(problem.to(), graph);
        Optional<List<Coordinate>> between = out.isEmpty() || in.isEmpty()
                ? Optional.empty()
                : graph.shortest(out.get(out.size() - 1), in.get(in.size() - 1));
        tested += graph.tested();
        return between.map(way -> new Route(out.size() > 1, way, in.size() > 1));
    }

    /** A way on the plane. */
    private final class Route {
        private final boolean
                leaves; // its first point is where a start that is too near is left to; else it is the start
        private final List<Coordinate> between;
        private final boolean enters; // the same of its last point and the goal
        private final List<GeoPoint> points;

        Route(boolean leaves, List<Coordinate> between, boolean enters) {
            this.leaves = leaves;
            this.between = between;
            this.enters = enters;
            points = new ArrayList<>();
            between.subList(leaves ? 0 : 1, between.size() - (enters ? 0 : 1))
                    .forEach(place -> points.add(Areas.point(place, water.plane())));
            points.add(problem.to());
        }

        List<Coordinate> between() {
            return between;
        }

        Route between(List<Coordinate> other) {
            return new Route(leaves, other, enters);
        }

        /** The points after the start. */
        List<GeoPoint> points() {
            return points;
        }

        List<GeoPoint> whole() {
            List<GeoPoint> whole = new ArrayList<>(List.of(problem.from()));
            whole.addAll(points);
            return whole;
        }

        double lengthM() {
            return Geodesy.lengthM(problem.from(), points);
        }
    }

    private String room() {
        double leastM = water.error().steeringM();
        return leastM == 0
                ? ""
                : String.format(
                        Locale.ROOT, ", or leaves gaps of less than %.1f m, in which boats cannot steer", 2 * leastM);
    }

    private Optional<String> forbiddenEnd() {
        if (water.clearanceM(problem.from()) <= 0) {
            return Optional.of("the start lies in what is forbidden");
        }
        if (water.clearanceM(problem.to()) <= 0) {
            return Optional.of("the goal lies in what is forbidden");
        }
        return Optional.empty();
    }

    /** From an end that is too near, straight to where the clearance is kept; empty where that way is barred. */
    private List<Coordinate> leave(GeoPoint end, VisibilityGraph graph) {
        Coordinate at = Areas.coordinate(end, water.plane());
        boolean blocked = graph.isBlocked(at);
        if (!blocked && !graph.isBehindCorners(at)) {
            return List.of(at);
        }
        Coordinate free = graph.nearestFree(at);
        GeoPoint outside = Areas.point(free, water.plane());
        tested++;
        if (!graph.isBlocked(free) && water.clearanceM(List.of(end, outside)) > 0) {
            return List.of(at, free);
        }
        return blocked ? List.of() : List.of(at);
    }

    private PathAnswer.Way way(List<GeoPoint> points, double wantedM) {
        List<GeoPoint> whole = new ArrayList<>(List.of(problem.from()));
        whole.addAll(points);
        double lengthM = Geodesy.lengthM(problem.from(), points);
        return new PathAnswer.Way(
                points, lengthM, water.clearanceM(whole), wantedM, lengthM, method, Math.max(1, tested));
    }
}
