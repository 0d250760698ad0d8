package org.sami.crw.report.picture;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;

/** The map without boats: water, grid with metres along the edges, scale bar, north arrow. */
final class WaterDrawing {
    private final Rectangle frame;
    private final MapScale scale;
    private final String axes;

    /** Of metres; the words say of what. */
    WaterDrawing(Rectangle frame, MapScale scale, String axes) {
        this.frame = frame;
        this.scale = scale;
        this.axes = axes;
    }

    void draw(Graphics2D g) {
        g.setColor(MapColors.WATER);
        g.fill(frame);
        grid(g);
        g.setColor(MapColors.FAINT_INK);
        g.setStroke(MapColors.dashed(1.2f));
        g.draw(frame);
        scaleBar(g);
        northArrow(g);
    }

    private void grid(Graphics2D g) {
        double step = scale.roundMetres(170);
        g.setFont(DrawnText.font(Font.PLAIN, 13));
        FontMetrics metrics = g.getFontMetrics();
        g.setStroke(MapColors.dashed(1));
        for (double east = Math.ceil(scale.westM() / step) * step; east <= scale.eastM(); east += step) {
            double x = scale.x(east);
            String label = metres(east);
            g.setColor(MapColors.GRID);
            g.draw(new Line2D.Double(x, frame.y, x, frame.getMaxY()));
            g.setColor(MapColors.FAINT_INK);
            g.drawString(label, (float) (x - metrics.stringWidth(label) / 2.0), (float) frame.getMaxY() + 20);
        }
        for (double north = Math.ceil(scale.southM() / step) * step; north <= scale.northM(); north += step) {
            double y = scale.y(north);
            String label = metres(north);
            g.setColor(MapColors.GRID);
            g.draw(new Line2D.Double(frame.x, y, frame.getMaxX(), y));
            g.setColor(MapColors.FAINT_INK);
            g.drawString(label, frame.x - 8 - metrics.stringWidth(label), (float) y + 5);
        }
        g.drawString(axes, (float) frame.getMaxX() - metrics.stringWidth(axes), (float) frame.getMaxY() + 42);
    }

    private static String metres(double value) {
        return String.valueOf(Math.round(value));
    }

    private void scaleBar(Graphics2D g) {
        double metres = scale.roundMetres(220);
        double length = scale.pixels(metres);
        double x = frame.x + 24;
        double y = frame.getMaxY() - 24;
        String label = metres(metres) + " m";
        g.setFont(DrawnText.font(Font.BOLD, 15));
        g.setColor(new java.awt.Color(255, 255, 255, 215));
        g.fill(new Rectangle2D.Double(x - 12, y - 36, length + 24, 50));
        g.setColor(MapColors.INK);
        g.fill(new Rectangle2D.Double(x, y - 4, length / 2, 7));
        g.setStroke(MapColors.dashed(1.2f));
        g.draw(new Rectangle2D.Double(x, y - 4, length, 7));
        int width = g.getFontMetrics().stringWidth(label);
        g.drawString(label, (float) (x + (length - width) / 2), (float) y - 14);
    }

    private void northArrow(Graphics2D g) {
        double x = frame.getMaxX() - 40;
        double y = frame.y + 34;
        g.setColor(new java.awt.Color(255, 255, 255, 215));
        g.fill(new Rectangle2D.Double(x - 24, y - 22, 48, 84));
        Path2D left = new Path2D.Double();
        left.moveTo(x, y - 14);
        left.lineTo(x - 12, y + 28);
        left.lineTo(x, y + 19);
        left.closePath();
        Path2D right = new Path2D.Double();
        right.moveTo(x, y - 14);
        right.lineTo(x + 12, y + 28);
        right.lineTo(x, y + 19);
        right.closePath();
        g.setStroke(MapColors.dashed(1.2f));
        g.setColor(MapColors.INK);
        g.fill(left);
        g.draw(left);
        g.draw(right);
        g.setFont(DrawnText.font(Font.BOLD, 17));
        g.drawString("N", (float) x - g.getFontMetrics().stringWidth("N") / 2f, (float) y + 50);
    }
}
