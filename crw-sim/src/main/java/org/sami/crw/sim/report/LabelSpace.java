package org.sami.crw.sim.report;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** Remembers what is drawn on the map already, so that names of boats are put where they cover least. */
final class LabelSpace {
    private static final double[][] SIDES = {
        {1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {2, 0}, {-2, 0}, {0, -2.4}, {0, 2.4}
    };

    private final Rectangle2D frame;
    private final List<Rectangle2D> taken = new ArrayList<>();

    LabelSpace(Rectangle2D frame) {
        this.frame = frame;
    }

    void take(Point2D centre, double radius) {
        taken.add(new Rectangle2D.Double(centre.getX() - radius, centre.getY() - radius, 2 * radius, 2 * radius));
    }

    /** Where a label beside a point goes; the place is taken from then on. */
    Rectangle2D place(Point2D beside, double width, double height) {
        Rectangle2D best = null;
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
