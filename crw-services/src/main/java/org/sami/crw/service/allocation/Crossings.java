package org.sami.crw.service.allocation;

import java.util.List;
import org.sami.crw.service.LocalPlane;
import org.sami.spn.value.GeoPoint;

/** Where paths of two boats cross. Legs that only touch do not. */
final class Crossings {
    private Crossings() {}

    /** Number of crossings of legs of two paths, over all pairs of paths. O(L²) for L points. */
    static int of(List<List<GeoPoint>> paths) {
        List<double[][]> onPlane = paths.stream()
                .filter(path -> path.size() > 1)
                .map(path -> onPlane(path, new LocalPlane(paths.get(0).get(0))))
                .toList();
        int crossings = 0;
        for (int a = 0; a < onPlane.size(); a++) {
            for (int b = 0; b < a; b++) {
                crossings += between(onPlane.get(a), onPlane.get(b));
            }
        }
        return crossings;
    }

    private static double[][] onPlane(List<GeoPoint> path, LocalPlane plane) {
        return path.stream()
                .map(point -> new double[] {plane.x(point), plane.y(point)})
                .toArray(double[][]::new);
    }

    private static int between(double[][] a, double[][] b) {
        int crossings = 0;
        for (int i = 1; i < a.length; i++) {
            for (int j = 1; j < b.length; j++) {
                if (cross(a[i - 1], a[i], b[j - 1], b[j])) {
                    crossings++;
                }
            }
        }
        return crossings;
    }

    private static boolean cross(double[] p, double[] q, double[] r, double[] s) {
        return side(p, q, r) * side(p, q, s) < 0 && side(r, s, p) * side(r, s, q) < 0;
    }

    private static double side(double[] p, double[] q, double[] r) {
        return Math.signum((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
    }
}
