package org.sami.ui.geo;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.sami.spn.value.GeoPoint;

/**
 * Finds the point that somebody means who points near it: the nearest corner within reach, else the nearest point of a line within reach.
 */
public final class Snapping {
    /** How far a pointer may be off, in pixels. */
    public static final double REACH_PX = 10;

    private final List<GeoPoint> corners = new ArrayList<>();
    private final List<List<GeoPoint>> lines = new ArrayList<>();

    /** Lets a pointer snap to a point. */
    public void addCorner(GeoPoint point) {
        corners.add(point);
    }

    /** Lets a pointer snap to the corners of a line and to the line itself. */
    public void addLine(List<GeoPoint> points) {
        corners.addAll(points);
        lines.add(List.copyOf(points));
    }

    /** Lets a pointer snap to the outline of an area. */
    public void addOutline(List<GeoPoint> points) {
        List<GeoPoint> closed = new ArrayList<>(points);
        if (!points.isEmpty()) {
            closed.add(points.get(0));
        }
        addLine(closed);
    }

    /** Where a pointer at a pixel of the map snaps to; none where nothing is near. */
    public Optional<GeoPoint> at(MapFrame frame, double px, double py) {
        Optional<GeoPoint> corner = nearest(frame, corners, px, py);
        return corner.isPresent()
                ? corner
                : nearest(
                        frame,
                        lines.stream()
                                .flatMap(line -> feet(frame, line, px, py).stream())
                                .toList(),
                        px,
                        py);
    }

    private static Optional<GeoPoint> nearest(MapFrame frame, List<GeoPoint> points, double px, double py) {
        return points.stream()
                .filter(point -> frame.distancePx(point, px, py) <= REACH_PX)
                .min(Comparator.comparingDouble(point -> frame.distancePx(point, px, py)));
    }

    /** The point nearest to the pointer on each part of a line. */
    private static List<GeoPoint> feet(MapFrame frame, List<GeoPoint> line, double px, double py) {
        List<GeoPoint> feet = new ArrayList<>();
        for (int i = 1; i < line.size(); i++) {
            double ax = frame.px(line.get(i - 1));
            double ay = frame.py(line.get(i - 1));
            double dx = frame.px(line.get(i)) - ax;
            double dy = frame.py(line.get(i)) - ay;
            double squared = dx * dx + dy * dy;
            double part = squared == 0 ? 0 : Math.max(0, Math.min(1, ((px - ax) * dx + (py - ay) * dy) / squared));
            feet.add(frame.point(ax + part * dx, ay + part * dy));
        }
        return feet;
    }
}
