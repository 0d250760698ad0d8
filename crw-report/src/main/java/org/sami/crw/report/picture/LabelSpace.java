package org.sami.crw.report.picture;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** Remembers what is drawn on the map already, so that names of boats and numbers of locations are put where they cover least. */
final class LabelSpace {
    private static final double[][] SIDES = {
        {1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {2, 0}, {-2, 0}, {0, -2.4}, {0, 2.4}
    };

    private final Rectangle2D frame;
    private final List<Rectangle2D> taken = new ArrayList<>();
    private final List<Point2D> discs = new ArrayList<>();

    LabelSpace(Rectangle2D frame) {
        this.frame = frame;
    }

    /** Where a disc for a point goes: on the point, else as near to it as it covers no other disc; its place is taken from then on. */
    Point2D disc(Point2D wanted, double radius) {
        Point2D best = wanted;
        double least = overlapped(wanted, radius);
        for (double away = 2 * radius; least > 0 && away <= 8 * radius; away += radius) {
            for (int turn = 0; turn < 16; turn++) {
                double angle = Math.PI * turn / 8;
                Point2D other = new Point2D.Double(
                        wanted.getX() + away * Math.cos(angle), wanted.getY() + away * Math.sin(angle));
                double covered = frame.contains(other) ? overlapped(other, radius) : Double.MAX_VALUE;
                if (covered < least) {
                    least = covered;
                    best = other;
                }
            }
        }
        discs.add(best);
        take(best, radius + 2);
        return best;
    }

    /**
     * Where a disc goes that is to stand ahead of a point: on it, or as far ahead that it covers no other disc.
     *
     * @param bearingRad clockwise from the top
     */
    Point2D ahead(Point2D wanted, double radius, double bearingRad) {
        for (double away = 0; away <= 4 * radius; away += 2) {
            Point2D other = new Point2D.Double(
                    wanted.getX() + away * Math.sin(bearingRad), wanted.getY() - away * Math.cos(bearingRad));
            if (overlapped(other, radius) == 0 && frame.contains(other)) {
                discs.add(other);
                take(other, radius);
                return other;
            }
        }
        return disc(wanted, radius);
    }

    /** By how much a disc would cover others, in pixels. */
    private double overlapped(Point2D centre, double radius) {
        return discs.stream()
                .mapToDouble(disc -> Math.max(0, 2 * radius + 1 - disc.distance(centre)))
                .sum();
    }

    void take(Point2D centre, double radius) {
        taken.add(new Rectangle2D.Double(centre.getX() - radius, centre.getY() - radius, 2 * radius, 2 * radius));
    }

    /** Where a label next to a point goes; the place is taken from then on. */
    Rectangle2D place(Point2D beside, double width, double height) {
        Rectangle2D best = new Rectangle2D.Double();
        double least = Double.MAX_VALUE;
        for (double[] side : SIDES) {
            Rectangle2D box = new Rectangle2D.Double(
                    beside.getX() + side[0] * (width / 2 + 12) - width / 2,
                    beside.getY() + side[1] * (height / 2 + 12) - height / 2,
                    width,
                    height);
            double covered = covered(box);
            if (covered < least) {
                least = covered;
                best = box;
            }
        }
        taken.add(best);
        return best;
    }

    private double covered(Rectangle2D box) {
        double sum = frame.contains(box) ? 0 : box.getWidth() * box.getHeight() * 2;
        for (Rectangle2D other : taken) {
            Rectangle2D both = box.createIntersection(other);
            sum += both.getWidth() > 0 && both.getHeight() > 0 ? both.getWidth() * both.getHeight() : 0;
        }
        return sum;
    }
}
