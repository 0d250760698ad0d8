package org.sami.ui.map;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Mercator;

/** A line through points, projected once: a pan or zoom scales it only. */
final class WorldLine {
    private static final double LEAST_PX = 1.5;
    private static final double MARGIN_PX = 10; // as wide as a line and its dots are

    private final List<GeoPoint> points;
    private final double[] xs;
    private final double[] ys;

    WorldLine(List<GeoPoint> points) {
        this.points = List.copyOf(points);
        xs = new double[points.size()];
        ys = new double[points.size()];
        project(0);
    }

    /** The line through points that are mostly those of a line before: these are not projected again. */
    WorldLine(List<GeoPoint> points, WorldLine before) {
        this.points = List.copyOf(points);
        int same = 0;
        int most = Math.min(points.size(), before.size());
        while (same < most && this.points.get(same).equals(before.points.get(same))) {
            same++;
        }
        xs = Arrays.copyOf(before.xs, points.size());
        ys = Arrays.copyOf(before.ys, points.size());
        project(same);
    }

    private void project(int from) {
        for (int i = from; i < xs.length; i++) {
            xs[i] = Mercator.x(points.get(i).lonDeg());
            ys[i] = Mercator.y(points.get(i).latDeg());
        }
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

    /** The line from one index to another, both included; points nearer to each other than can be seen are drawn as one. */
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

    /** Draws the legs from one index to another, each for itself: quick for a few, with a stroke that has no round ends. */
    void drawLegs(Graphics2D g, MapFrame frame, int from, int to) {
        double lastX = px(frame, from);
        double lastY = py(frame, from);
        for (int i = from + 1; i <= to; i++) {
            double x = px(frame, i);
            double y = py(frame, i);
            if (i == to || Math.abs(x - lastX) + Math.abs(y - lastY) >= LEAST_PX) {
                g.draw(new Line2D.Double(lastX, lastY, x, y));
                lastX = x;
                lastY = y;
            }
        }
    }

    /** Whether some of the line may be seen on the map. */
    boolean isNear(MapFrame frame) {
        double left = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double top = Double.POSITIVE_INFINITY;
        double bottom = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < xs.length; i++) {
            left = Math.min(left, xs[i]);
            right = Math.max(right, xs[i]);
            top = Math.min(top, ys[i]);
            bottom = Math.max(bottom, ys[i]);
        }
        return frame.px(right) >= -MARGIN_PX
                && frame.px(left) <= frame.width() + MARGIN_PX
                && frame.py(bottom) >= -MARGIN_PX
                && frame.py(top) <= frame.height() + MARGIN_PX;
    }

    /** How far the nearest part of the line is from a pixel, in pixels; infinite where there is no line. */
    double distancePx(MapFrame frame, double x, double y) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 1; i < size(); i++) {
            nearest = Math.min(
                    nearest, Line2D.ptSegDist(px(frame, i - 1), py(frame, i - 1), px(frame, i), py(frame, i), x, y));
        }
        return nearest;
    }
}
