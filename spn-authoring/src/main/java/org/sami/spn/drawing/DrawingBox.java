package org.sami.spn.drawing;

import org.sami.spn.model.LayoutPoint;

/** A rectangle of a drawing, its left upper corner first. */
public record DrawingBox(double x, double y, double width, double height) {
    /** Its right edge. */
    public double maxX() {
        return x + width;
    }

    /** Its lower edge. */
    public double maxY() {
        return y + height;
    }

    /** Whether both have some area in common. */
    public boolean intersects(DrawingBox other) {
        return other.x < maxX() && other.maxX() > x && other.y < maxY() && other.maxY() > y;
    }

    /** Whether a point lies in it or on its rim. */
    public boolean contains(double px, double py) {
        return px >= x && px <= maxX() && py >= y && py <= maxY();
    }

    /** Whether all of another box lies in it. */
    public boolean contains(DrawingBox other) {
        return other.x >= x && other.maxX() <= maxX() && other.y >= y && other.maxY() <= maxY();
    }

    /** The same box with so much more on every side. */
    public DrawingBox grown(double by) {
        return new DrawingBox(x - by, y - by, width + 2 * by, height + 2 * by);
    }

    /** The box around both. */
    public DrawingBox union(DrawingBox other) {
        double left = Math.min(x, other.x);
        double top = Math.min(y, other.y);
        return new DrawingBox(left, top, Math.max(maxX(), other.maxX()) - left, Math.max(maxY(), other.maxY()) - top);
    }

    /** Whether some of the line between two points lies in it (Liang and Barsky's clipping). */
    public boolean isCrossedBy(LayoutPoint from, LayoutPoint to) {
        if (Math.max(from.x(), to.x()) < x
                || Math.min(from.x(), to.x()) > maxX()
                || Math.max(from.y(), to.y()) < y
                || Math.min(from.y(), to.y()) > maxY()) {
            return false; // most lines, at little cost
        }
        double dx = to.x() - from.x();
        double dy = to.y() - from.y();
        double[] towards = {-dx, dx, -dy, dy};
        double[] room = {from.x() - x, maxX() - from.x(), from.y() - y, maxY() - from.y()};
        double enters = 0;
        double leaves = 1;
        for (int side = 0; side < towards.length; side++) {
            if (towards[side] == 0) {
                if (room[side] < 0) {
                    return false;
                }
            } else if (towards[side] < 0) {
                enters = Math.max(enters, room[side] / towards[side]);
            } else {
                leaves = Math.min(leaves, room[side] / towards[side]);
            }
        }
        return enters <= leaves;
    }
}
