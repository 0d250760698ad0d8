package org.sami.crw.sim.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import org.sami.crw.sim.picture.Perspective.Spot;
import org.sami.crw.sim.picture.Scene.SeenBoat;

/** Draws one thing on the water each, at its size, with its shadow. */
final class SeenThings {
    /** Length of a boat in metres. */
    static final double BOAT_M = 1.6;

    /** Width of the jetty in metres. */
    static final double JETTY_M = 5;

    /** For names and scales. */
    static final Font SMALL = new Font(Font.SANS_SERIF, Font.PLAIN, 12);

    private static final Color INK = new Color(0x2B3338);

    private SeenThings() {}

    static void object(Graphics2D to, Spot spot, FloatingObject.Kind kind) {
        double w = kind.widthM * spot.scale();
        double h = kind.heightM * spot.scale();
        double left = spot.x() - w / 2;
        double top = spot.y() - h;
        shadow(to, spot, w);
        switch (kind) {
            case RED_BUOY -> buoy(to, spot, w, h, new Color(0xD5402B));
            case YELLOW_BUOY -> buoy(to, spot, w, h, new Color(0xF0B429));
            case BARREL -> {
                to.setColor(new Color(0x2F6DB5));
                to.fill(new RoundRectangle2D.Double(left, top, w, h, h * 0.5, h * 0.8));
                to.setColor(new Color(0x234F85));
                to.fill(new Rectangle2D.Double(left + w * 0.3, top, w * 0.06, h));
                to.fill(new Rectangle2D.Double(left + w * 0.66, top, w * 0.06, h));
            }
            case DRIFTWOOD -> {
                to.setColor(new Color(0x6B4E37));
                to.fill(new RoundRectangle2D.Double(left, top + h * 0.35, w, h * 0.65, h, h));
                to.setStroke(new BasicStroke((float) Math.max(1, h * 0.25)));
                to.draw(new Line2D.Double(left + w * 0.7, top + h * 0.5, left + w * 0.85, top - h * 0.7));
            }
        }
    }

    private static void buoy(Graphics2D to, Spot spot, double w, double h, Color color) {
        double top = spot.y() - h;
        Path2D cone = new Path2D.Double();
        cone.moveTo(spot.x() - w / 2, spot.y() - h * 0.12);
        cone.lineTo(spot.x() - w * 0.14, top + h * 0.12);
        cone.lineTo(spot.x() + w * 0.14, top + h * 0.12);
        cone.lineTo(spot.x() + w / 2, spot.y() - h * 0.12);
        cone.curveTo(
                spot.x() + w / 2,
                spot.y() + h * 0.08,
                spot.x() - w / 2,
                spot.y() + h * 0.08,
                spot.x() - w / 2,
                spot.y() - h * 0.12);
        to.setColor(color);
        to.fill(cone);
        to.setColor(new Color(255, 255, 255, 70));
        to.fill(new Ellipse2D.Double(spot.x() - w * 0.2, top + h * 0.25, w * 0.14, h * 0.5));
        to.setColor(color.darker());
        to.fill(new Ellipse2D.Double(spot.x() - w * 0.16, top, w * 0.32, w * 0.32));
    }

    /** A boat, or a copter at its height above the water. */
    static void robot(Graphics2D to, Spot spot, SeenBoat robot, double viewRad, Font font) {
        if (robot.flies()) {
            copter(to, spot, robot, font);
        } else {
            boat(to, spot, robot, viewRad, font);
        }
    }

    /** Arms with rotors from the side; its shadow lies on the water below. */
    private static void copter(Graphics2D to, Spot spot, SeenBoat copter, Font font) {
        double s = spot.scale();
        double y = spot.y() - (copter.at().altM() + 0.25) * s;
        shadow(to, spot, 0.9 * s);
        to.setColor(INK);
        to.fill(new Rectangle2D.Double(spot.x() - 0.5 * s, y - 0.04 * s, s, Math.max(1, 0.08 * s)));
        to.fill(new RoundRectangle2D.Double(spot.x() - 0.2 * s, y - 0.12 * s, 0.4 * s, 0.26 * s, 0.1 * s, 0.1 * s));
        to.setColor(new Color(230, 238, 242, 150));
        for (int side = -1; side <= 1; side += 2) {
            to.fill(new Ellipse2D.Double(
                    spot.x() + side * 0.5 * s - 0.36 * s, y - 0.16 * s, 0.72 * s, Math.max(1, 0.08 * s)));
        }
        tag(to, copter.name(), spot.x(), y - 0.3 * s - 5, font);
    }

    /** A hull with a box and a mast; how long it looks follows from how it lies. */
    private static void boat(Graphics2D to, Spot spot, SeenBoat boat, double viewRad, Font font) {
        double turn = boat.headingRad() - viewRad;
        double side = StrictMath.sin(turn);
        double w = (0.55 + (BOAT_M - 0.55) * Math.abs(side)) * spot.scale();
        double h = 0.38 * spot.scale();
        double bow = side >= 0 ? 1 : -1;
        double y = spot.y();
        shadow(to, spot, w);
        Path2D hull = new Path2D.Double();
        hull.moveTo(spot.x() - bow * w / 2, y - h);
        hull.lineTo(spot.x() + bow * w * (0.5 + 0.12 * Math.abs(side)), y - h * 1.05);
        hull.lineTo(spot.x() + bow * w * 0.36, y);
        hull.lineTo(spot.x() - bow * w * 0.46, y);
        hull.closePath();
        to.setColor(new Color(0xF4F1E8));
        to.fill(hull);
        to.setColor(new Color(0xE0672A));
        to.fill(new Rectangle2D.Double(spot.x() - w * 0.44, y - h * 0.42, w * 0.84, h * 0.2));
        double box = Math.min(w, 0.5 * spot.scale());
        to.setColor(new Color(0x3C474D));
        to.fill(new RoundRectangle2D.Double(
                spot.x() - bow * w * 0.12 - box / 2, y - h * 1.75, box, h * 0.78, box * 0.2, box * 0.2));
        to.setStroke(new BasicStroke((float) Math.max(1, 0.035 * spot.scale())));
        to.draw(new Line2D.Double(spot.x() - bow * w * 0.12, y - h * 1.75, spot.x() - bow * w * 0.12, y - h * 3.1));
        to.setStroke(new BasicStroke(1));
        to.setColor(INK);
        if (spot.scale() > 6) {
            to.draw(hull);
        }
        tag(to, boat.name(), spot.x(), y - h * 3.1 - 5, font);
    }

    static void tag(Graphics2D to, String name, double x, double bottom, Font font) {
        to.setFont(font);
        double width = to.getFontMetrics().stringWidth(name);
        to.setColor(new Color(20, 28, 32, 150));
        to.fill(new RoundRectangle2D.Double(x - width / 2 - 5, bottom - 15, width + 10, 17, 6, 6));
        to.setColor(Color.WHITE);
        to.drawString(name, (float) (x - width / 2), (float) (bottom - 3));
    }

    /** Planks on piles, where boats are launched. */
    static void jetty(Graphics2D to, Spot spot) {
        double s = spot.scale();
        double left = spot.x() - JETTY_M / 2 * s;
        shadow(to, spot, JETTY_M * s);
        to.setColor(new Color(0x5A4636));
        for (int pile = 0; pile <= 4; pile++) {
            double x = left + pile * JETTY_M / 4 * s;
            to.fill(new Rectangle2D.Double(x - 0.09 * s, spot.y() - 0.9 * s, 0.18 * s, 0.9 * s));
        }
        to.setColor(new Color(0x9A7B57));
        to.fill(new Rectangle2D.Double(left - 0.2 * s, spot.y() - 0.78 * s, (JETTY_M + 0.4) * s, 0.2 * s));
        to.setColor(new Color(0xB89770));
        to.fill(new Rectangle2D.Double(left - 0.2 * s, spot.y() - 0.78 * s, (JETTY_M + 0.4) * s, 0.07 * s));
        to.setColor(INK);
        to.fill(new Rectangle2D.Double(spot.x() - 0.04 * s, spot.y() - 3.2 * s, 0.08 * s, 2.5 * s));
        to.setColor(new Color(0x2E8B57));
        to.fill(new Rectangle2D.Double(spot.x() + 0.04 * s, spot.y() - 3.2 * s, 0.9 * s, 0.55 * s));
    }

    private static void shadow(Graphics2D to, Spot spot, double width) {
        double height = Math.max(1, width * 0.1);
        to.setColor(new Color(12, 40, 52, 90));
        to.fill(new Ellipse2D.Double(spot.x() - width * 0.6, spot.y() - height / 3, width * 1.2, height));
    }
}
