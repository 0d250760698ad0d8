package org.sami.ui.map;

import java.awt.geom.Path2D;
import java.util.List;
import java.util.Optional;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Mercator;

/** A line through points, projected once: a pan or zoom scales it only. */
final class WorldLine {
    private static final double LEAST_PX = 1;

    private final List<GeoPoint> points;
    private final double[] xs;
    private final double[] ys;

    WorldLine(List<GeoPoint> points) {
        this.points = List.copyOf(points);
        xs = points.stream().mapToDouble(point -> Mercator.x(point.lonDeg())).toArray();
        ys = points.stream().mapToDouble(point -> Mercator.y(point.latDeg())).toArray();
    }

    List<GeoPoint> points() {
        return points;
    }

    int size() {
        return xs.length;
    }

    double px(MapFrame frame, int index) {
        return frame.px(xs[index]);
    }

    double py(MapFrame frame, int index) {
        return frame.py(ys[index]);
    }

    Optional<GeoBounds> bounds() {
        return GeoBounds.of(points);
    }

    /** The line from one index to another, both included; points less than a pixel apart are drawn as one. */
    Path2D path(MapFrame frame, int from, int to) {
        Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD, to - from + 2);
        double lastX = px(frame, from);
        double lastY = py(frame, from);
        path.moveTo(lastX, lastY);
        for (int i = from + 1; i <= to; i++) {
            double x = px(frame, i);
            double y = py(frame, i);
            if (i == to || Math.abs(x - lastX) + Math.abs(y - lastY) >= LEAST_PX) {
                path.lineTo(x, y);
                lastX = x;
                lastY = y;
            }
        }
        return path;
    }

    /** The whole line. */
    Path2D path(MapFrame frame) {
        return path(frame, 0, size() - 1);
    }

    /** How far the nearest part of the line is from a pixel, in pixels; infinite where there is no line. */
    double distancePx(MapFrame frame, double x, double y) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 1; i < size(); i++) {
            nearest = Math.min(
                    nearest,
                    java.awt.geom.Line2D.ptSegDist(
                            px(frame, i - 1), py(frame, i - 1), px(frame, i), py(frame, i), x, y));
        }
        return nearest;
    }
}
