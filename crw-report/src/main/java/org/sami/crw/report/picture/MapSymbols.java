package org.sami.crw.report.picture;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import org.jspecify.annotations.Nullable;
import org.sami.palette.Contrast;

/** The signs of the map; the legend shows the same. */
final class MapSymbols {
    static final double LOCATION_RADIUS = 12;

    private MapSymbols() {}

    /** A numbered location: filled with the visitor's colour, or empty with a dashed rim. */
    static void location(Graphics2D g, Point2D at, String number, @Nullable Color visitor, double radius) {
        Shape disc = circle(at, radius);
        g.setColor(visitor == null ? MapColors.PAPER : visitor);
        g.fill(disc);
        g.setColor(MapColors.INK);
        g.setStroke(visitor == null ? MapColors.dashed(1.8f, 4, 3) : MapColors.dashed(1.2f));
        g.draw(disc);
        g.setColor(visitor == null ? MapColors.INK : Contrast.inkOn(visitor));
        centred(g, at, number, number.length() > 2 ? 12 : 13);
    }

    private static void centred(Graphics2D g, Point2D at, String text, int size) {
        g.setFont(DrawnText.font(Font.BOLD, size));
        FontMetrics metrics = g.getFontMetrics();
        g.drawString(text, (float) (at.getX() - metrics.stringWidth(text) / 2.0), (float)
                (at.getY() + (metrics.getAscent() - metrics.getDescent()) / 2.0));
    }

    /** The quay. */
    static void quay(Graphics2D g, Point2D at) {
        g.setColor(MapColors.INK);
        g.fill(new RoundRectangle2D.Double(at.getX() - 10, at.getY() - 10, 20, 20, 6, 6));
        g.setColor(MapColors.PAPER);
        centred(g, at, "Q", 14);
    }

    /** North is up: an arrow with the letter next to it. */
    static void north(Graphics2D g, Point2D at) {
        for (int side = -1; side <= 1; side += 2) {
            Path2D half = new Path2D.Double();
            half.moveTo(at.getX(), at.getY() - 16);
            half.lineTo(at.getX() + side * 8, at.getY() + 12);
            half.lineTo(at.getX(), at.getY() + 6);
            half.closePath();
            g.setColor(side < 0 ? MapColors.INK : MapColors.PAPER);
            g.fill(half);
            g.setColor(MapColors.INK);
            g.setStroke(MapColors.dashed(1.2f));
            g.draw(half);
        }
        centred(g, new Point2D.Double(at.getX() - 20, at.getY()), "N", 17);
    }

    /** A point of the plan: a diamond. */
    static void planPoint(Graphics2D g, Point2D at) {
        Path2D diamond = new Path2D.Double();
        diamond.moveTo(at.getX(), at.getY() - 8);
        diamond.lineTo(at.getX() + 8, at.getY());
        diamond.lineTo(at.getX(), at.getY() + 8);
        diamond.lineTo(at.getX() - 8, at.getY());
        diamond.closePath();
        g.setColor(new Color(255, 255, 255, 220));
        g.fill(diamond);
        g.setColor(MapColors.INK);
        g.setStroke(MapColors.dashed(2));
        g.draw(diamond);
    }

    /** A boat's place where boats gathered: two rings. */
    static void assembly(Graphics2D g, Point2D at, Color color) {
        g.setStroke(MapColors.dashed(5));
        g.setColor(MapColors.PAPER);
        g.draw(circle(at, 9));
        g.setStroke(MapColors.dashed(2.4f));
        g.setColor(color);
        g.draw(circle(at, 9));
        g.fill(circle(at, 3));
    }

    /** Where two boats came nearest to one another: two wedges, point to point. */
    static void approach(Graphics2D g, Point2D at) {
        Path2D wedges = new Path2D.Double();
        for (int side = -1; side <= 1; side += 2) {
            wedges.moveTo(at.getX() + side * 2, at.getY());
            wedges.lineTo(at.getX() + side * 13, at.getY() - 7);
            wedges.lineTo(at.getX() + side * 13, at.getY() + 7);
            wedges.closePath();
        }
        g.setColor(MapColors.PAPER);
        g.setStroke(MapColors.dashed(3));
        g.draw(wedges);
        g.setColor(MapColors.INK);
        g.fill(wedges);
    }

    /** Where a boat started: a square. */
    static void start(Graphics2D g, Point2D at, Color color) {
        Rectangle2D square = new Rectangle2D.Double(at.getX() - 6, at.getY() - 6, 12, 12);
        g.setColor(color);
        g.fill(square);
        g.setColor(MapColors.INK);
        g.setStroke(MapColors.dashed(1.4f));
        g.draw(square);
    }

    /** Where a boat is at the end: an arrowhead in the direction of its way. */
    static void boat(Graphics2D g, Point2D at, double bearingRad, Color color) {
        Path2D hull = new Path2D.Double();
        hull.moveTo(0, -13);
        hull.lineTo(8, 9);
        hull.lineTo(0, 4);
        hull.lineTo(-8, 9);
        hull.closePath();
        Graphics2D turned = (Graphics2D) g.create();
        turned.translate(at.getX(), at.getY());
        turned.rotate(bearingRad);
        turned.setColor(color);
        turned.fill(hull);
        turned.setColor(MapColors.INK);
        turned.setStroke(MapColors.dashed(1.6f));
        turned.draw(hull);
        turned.dispose();
    }

    private static Shape circle(Point2D at, double radius) {
        return new Ellipse2D.Double(at.getX() - radius, at.getY() - radius, 2 * radius, 2 * radius);
    }
}
