package org.sami.ui.geo;

import java.util.List;
import java.util.Optional;
import org.sami.spn.value.GeoPoint;

/** Whether the outline of an area is a simple polygon. */
final class Outline {
    /** The first points of two edges that cross. */
    record Crossing(int first, int second) {}

    private Outline() {}

    /** The first two edges that cross each other; none where the outline is simple. */
    static Optional<Crossing> crossing(List<GeoPoint> points) {
        int n = points.size();
        for (int i = 0; i < n; i++) {
            for (int j = i + 2; j < n; j++) {
                boolean neighbours = i == 0 && j == n - 1;
                if (!neighbours && cross(points.get(i), points.get(i + 1), points.get(j), points.get((j + 1) % n))) {
                    return Optional.of(new Crossing(i, j));
                }
            }
        }
        return Optional.empty();
    }

    private static boolean cross(GeoPoint a, GeoPoint b, GeoPoint c, GeoPoint d) {
        return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
    }

    /** On which side of the line from a to b the point lies: positive, negative, or 0 on it. */
    private static double side(GeoPoint a, GeoPoint b, GeoPoint point) {
        return Math.signum((b.lonDeg() - a.lonDeg()) * (point.latDeg() - a.latDeg())
                - (b.latDeg() - a.latDeg()) * (point.lonDeg() - a.lonDeg()));
    }
}
