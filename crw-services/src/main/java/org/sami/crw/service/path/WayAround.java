package org.sami.crw.service.path;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * Finds the shortest way for a problem that keeps a clearance where there is room. In gaps that are too narrow it keeps as much of it as
 * they allow, and never less than the boats' steering needs; a gap is taken where keeping all of the clearance costs more than the
 * problem's detour.
 */
final class WayAround {
    /** What of the clearance is tried in gaps, the most first. */
    private static final double[] PARTS = {0.9, 0.75, 0.5, 0.25, 0.1};

    private final PathProblem problem;
    private final Water water;
    private final String method;
    private long tested;
    private double wantedM;

    WayAround(PathProblem problem, String method) {
        this.problem = problem;
        this.method = method;
        water = problem.water();
    }

    PathAnswer find(double clearanceM) {
        if (water.isOpen()) {
            return way(List.of(problem.to()));
        }
        Optional<String> forbidden = forbiddenEnd();
        if (forbidden.isPresent()) {
            return new PathAnswer.NoWay(forbidden.get(), tested);
        }
        double leastM = water.error().steeringM();
        wantedM = leastM;
        PathAnswer shortest = find(VisibilityGraph.of(water, leastM));
        if (clearanceM <= leastM || !(shortest instanceof PathAnswer.Way tight)) {
            return shortest;
        }
        wantedM = clearanceM;
        double longestM = problem.detour() * tight.lengthM();
        PathAnswer kept = find(VisibilityGraph.of(water, clearanceM));
        for (int i = 0; !isWorth(kept, longestM) && i < PARTS.length; i++) {
            double gapM = Math.max(leastM, PARTS[i] * clearanceM);
            kept = find(VisibilityGraph.withGaps(water, clearanceM, gapM));
        }
        return isWorth(kept, longestM) ? ((PathAnswer.Way) kept).than(tight.lengthM()) : shortest;
    }

    private static boolean isWorth(PathAnswer answer, double longestM) {
        return answer instanceof PathAnswer.Way way && way.lengthM() <= longestM;
    }

    private PathAnswer find(VisibilityGraph graph) {
        List<Coordinate> out = leave(problem.from(), graph);
        List<Coordinate> in = leave(problem.to(), graph);
        Optional<List<Coordinate>> between = out.isEmpty() || in.isEmpty()
                ? Optional.empty()
                : graph.shortest(out.get(out.size() - 1), in.get(in.size() - 1));
        tested += graph.tested();
        return between.map(way -> way(joined(out, way, in)))
                .orElseGet(() -> new PathAnswer.NoWay(
                        "what is forbidden lies all the way between start and goal" + room(), tested));
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

    /** The points after the start. */
    private List<GeoPoint> joined(List<Coordinate> out, List<Coordinate> way, List<Coordinate> in) {
        List<Coordinate> all = new ArrayList<>(way.subList(1, way.size() - 1));
        if (out.size() > 1) {
            all.add(0, out.get(1));
        }
        if (in.size() > 1) {
            all.add(in.get(1));
        }
        List<GeoPoint> points = new ArrayList<>();
        all.forEach(place -> points.add(Areas.point(place, water.plane())));
        points.add(problem.to());
        return points;
    }

    private PathAnswer way(List<GeoPoint> points) {
        List<GeoPoint> whole = new ArrayList<>(List.of(problem.from()));
        whole.addAll(points);
        double lengthM = Geodesy.lengthM(problem.from(), points);
        return new PathAnswer.Way(
                points, lengthM, water.clearanceM(whole), wantedM, lengthM, method, Math.max(1, tested));
    }
}
