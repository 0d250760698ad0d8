package org.sami.palette;

import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;

/** The shapes of marks: the first for the first twelve proxies, the next where colours repeat. */
public enum MarkShape {
    /** A disc. */
    CIRCLE,
    /** A square. */
    SQUARE,
    /** A triangle that points up. */
    TRIANGLE,
    /** A square on its tip. */
    DIAMOND,
    /** A hexagon. */
    HEXAGON;

    /** The shape around a centre, about as large as a disc of this diameter. */
    public Shape around(double x, double y, double diameter) {
        double r = diameter / 2;
        return switch (this) {
            case CIRCLE -> new Ellipse2D.Double(x - r, y - r, diameter, diameter);
            case SQUARE -> new Rectangle2D.Double(x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r);
            case TRIANGLE -> polygon(x, y + 0.2 * r, 1.2 * r, 3, -Math.PI / 2);
            case DIAMOND -> polygon(x, y, 1.15 * r, 4, 0);
            case HEXAGON -> polygon(x, y, 1.05 * r, 6, 0);
        };
    }

    private static Shape polygon(double x, double y, double radius, int corners, double from) {
        Path2D path = new Path2D.Double();
        for (int i = 0; i < corners; i++) {
            double angle = from + 2 * Math.PI * i / corners;
            double px = x + radius * Math.cos(angle);
            double py = y + radius * Math.sin(angle);
            if (i == 0) {
                path.moveTo(px, py);
            } else {
                path.lineTo(px, py);
            }
        }
        path.closePath();
        return path;
    }
}
