package org.sami.crw.service.placement;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.allocation.LeastSumAssignment;
import org.sami.spn.value.GeoPoint;

/**
 * Assembly on a hexagonal grid: the centre first, then the rings around it, each from the east turning north. Of all grids with
 * that spacing it keeps the boats closest together. The locations are given out so that the sum of the boats' distances
 * is least, so two boats do not cross; that takes O(n³) for n boats (250 boats: some tens of milliseconds).
 */
public final class HexagonalAssembly implements AssemblyAlgorithm {
    /** Two boats may be nearer than the spacing by this part of it: the grid is laid on an ellipsoid. */
    private static final double SLACK = 1e-4;
    /** Farther out nobody would say that the boats are near. */
    private static final int MOST_RINGS = 100;
    /** Steps along the six sides of a ring that begins in the east, in units of the grid's two axes. */
    private static final int[][] SIDES = {{-1, 1}, {-1, 0}, {0, -1}, {1, -1}, {1, 0}, {0, 1}};

    @Override
    public Map<String, GeoPoint> assemble(AssemblyProblem problem) {
        List<GeoPoint> places = places(problem);
        List<Optional<GeoPoint>> boats = List.copyOf(problem.boats().values());
        double[][] distances = new double[boats.size()][places.size()];
        for (int b = 0; b < boats.size(); b++) {
            for (int p = 0; p < places.size(); p++) {
                GeoPoint place = places.get(p);
                distances[b][p] =
                        boats.get(b).map(at -> Geodesy.distanceM(at, place)).orElse(0.0);
            }
        }
        int[] placeOf = LeastSumAssignment.of(distances);
        Map<String, GeoPoint> assembled = new LinkedHashMap<>();
        int b = 0;
        for (String boat : problem.boats().keySet()) {
            assembled.put(boat, places.get(placeOf[b++]));
        }
        return assembled;
    }

    private static List<GeoPoint> places(AssemblyProblem problem) {
        List<GeoPoint> places = new ArrayList<>();
        for (int ring = 0; places.size() < problem.boats().size(); ring++) {
            if (ring > MOST_RINGS) {
                throw new IllegalArgumentException(
                        "There is no room for " + problem.boats().size() + " boats within "
                                + Math.round(ring * problem.spacingM()) + " m, clear of no-go areas");
            }
            for (GeoPoint candidate : ring(problem, ring)) {
                if (places.size() < problem.boats().size() && isFree(candidate, problem)) {
                    places.add(candidate);
                }
            }
        }
        return places;
    }

    private static List<GeoPoint> ring(AssemblyProblem problem, int ring) {
        if (ring == 0) {
            return List.of(problem.centre());
        }
        List<GeoPoint> points = new ArrayList<>();
        int a = ring;
        int b = 0;
        for (int[] side : SIDES) {
            for (int step = 0; step < ring; step++) {
                double eastM = problem.spacingM() * (a + b / 2.0);
                double northM = problem.spacingM() * b * Math.sqrt(3) / 2;
                points.add(Geodesy.offset(problem.centre(), eastM, northM));
                a += side[0];
                b += side[1];
            }
        }
        return points;
    }

    private static boolean isFree(GeoPoint candidate, AssemblyProblem problem) {
        double leastM = problem.spacingM() * (1 - SLACK);
        return problem.water().clearanceM(candidate)
                        >= Math.max(
                                problem.spacingM() / 2, problem.water().margin().pathM())
                && problem.taken().stream().allMatch(taken -> Geodesy.distanceM(taken, candidate) >= leastM);
    }
}
