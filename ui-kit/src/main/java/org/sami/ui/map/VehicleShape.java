package org.sami.ui.map;

import java.awt.BasicStroke;
import java.awt.Shape;
import java.awt.geom.Area;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;

/** What vehicles look like on a map, from above. */
public enum VehicleShape {
    /** A hull with its bow. */
    HULL(hull()),
    /** Four rotors on two arms, with the nose between the front ones. */
    COPTER(copter());

    /** From the middle to the bow or the nose, in logical pixels. */
    static final double HALF_PX = 13;

    private static final double ROTOR_PX = 4.2;
    private static final double ARM_PX = 8;

    private final Shape outline;

    VehicleShape(Shape outline) {
        this.outline = outline;
    }

    /** The front up, the middle at the origin, in logical pixels. */
    Shape outline() {
        return outline;
    }

    private static Shape hull() {
        Path2D hull = new Path2D.Double();
        hull.moveTo(0, -HALF_PX);
        hull.curveTo(6, -7, 6.5, 0, 5.5, HALF_PX - 3);
        hull.lineTo(-5.5, HALF_PX - 3);
        hull.curveTo(-6.5, 0, -6, -7, 0, -HALF_PX);
        hull.closePath();
        return hull;
    }

    private static Shape copter() {
        Path2D nose = new Path2D.Double();
        nose.moveTo(0, -HALF_PX);
        nose.lineTo(3.5, 0);
        nose.lineTo(-3.5, 0);
        nose.closePath();
        Area all = new Area(nose);
        BasicStroke arm = new BasicStroke(3);
        all.add(new Area(arm.createStrokedShape(new Line2D.Double(-ARM_PX, -ARM_PX, ARM_PX, ARM_PX))));
        all.add(new Area(arm.createStrokedShape(new Line2D.Double(-ARM_PX, ARM_PX, ARM_PX, -ARM_PX))));
        for (int x : new int[] {-1, 1}) {
            for (int y : new int[] {-1, 1}) {
                all.add(new Area(new Ellipse2D.Double(
                        x * ARM_PX - ROTOR_PX, y * ARM_PX - ROTOR_PX, 2 * ROTOR_PX, 2 * ROTOR_PX)));
            }
        }
        return all;
    }
}
