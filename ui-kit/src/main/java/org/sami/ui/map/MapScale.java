package org.sami.ui.map;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import org.sami.palette.SemanticColor;
import org.sami.ui.geo.GeoMeasure;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Mercator;

/** The grid of a map, its scale and where north is. A side of the grid is as long as the scale. */
final class MapScale {
    private static final double LEAST_PX = 72;
    private static final double MARGIN = 12;
    private static final double TICK = 5;
    private static final double ARROW = 16;

    /** How long a side of the grid is, in metres: 1, 2 or 5 times a power of ten. */
    static double sideM(MapFrame frame) {
        double least = Painting.px(LEAST_PX) * frame.metresPerPixel();
        double power = Math.pow(10, Math.floor(Math.log10(least)));
        for (double times : new double[] {1, 2, 5}) {
            if (power * times >= least) {
                return power * times;
            }
        }
        return power * 10;
    }

    /** Where the scale ends at its right, in pixels; its plate included. */
    static double right(MapPaint paint) {
        double side = sideM(paint.frame());
        double wide = Math.max(
                side / paint.frame().metresPerPixel(),
                paint.g().getFontMetrics().stringWidth(words(side)));
        return Painting.px(MARGIN) + Painting.px(30) + wide + 10;
    }

    private static String words(double sideM) {
        return sideM < 1 ? Math.round(sideM * 100) + " cm" : plain(sideM);
    }

    /** Lines of metres from the corner of a degree, so that they stay where they are while the map moves. */
    void paintGrid(MapPaint paint) {
        MapFrame frame = paint.frame();
        Graphics2D g = paint.g();
        double side = sideM(frame) / frame.metresPerPixel();
        if (sideM(frame) > 100_000) {
            return; // metres are no grid for half the world
        }
        double originX = frame.px(
                Mercator.x(Math.floor(frame.point(frame.width() / 2.0, 0).lonDeg())));
        double originY = frame.py(Mercator.y(Math.floor(
                frame.point(frame.width() / 2.0, frame.height() / 2.0).latDeg())));
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
        g.setColor(SemanticColor.MAP_GRID.get());
        g.setStroke(Painting.line(1));
        for (double x = floorMod(originX, side); x < frame.width(); x += side) {
            g.drawLine((int) Math.round(x), 0, (int) Math.round(x), frame.height());
        }
        for (double y = floorMod(originY, side); y < frame.height(); y += side) {
            g.drawLine(0, (int) Math.round(y), frame.width(), (int) Math.round(y));
        }
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    }

    private static double floorMod(double value, double by) {
        return value - by * Math.floor(value / by);
    }

    /** The scale in the lower left corner with north next to it, and the base map's attribution. */
    void paint(MapPaint paint, String attribution) {
        paint.font(MapPaint.PLAIN);
        Graphics2D g = paint.g();
        MapFrame frame = paint.frame();
        FontMetrics metrics = g.getFontMetrics();
        double sideM = sideM(frame);
        double length = sideM / frame.metresPerPixel();
        String text = words(sideM);
        double margin = Painting.px(MARGIN);
        double left = margin + Painting.px(30);
        double base = frame.height() - margin;
        double height = metrics.getHeight() + Painting.px(TICK) + 4;
        g.setColor(SemanticColor.SURFACE.withAlpha(220));
        g.fill(new Rectangle2D.Double(
                margin - 4,
                base - height,
                left - margin + Math.max(length, metrics.stringWidth(text)) + 14,
                height + 6));
        g.setColor(SemanticColor.MAP_TEXT.get());
        g.setStroke(Painting.line(2));
        Path2D bar = new Path2D.Double();
        bar.moveTo(left, base - Painting.px(TICK));
        bar.lineTo(left, base);
        bar.lineTo(left + length, base);
        bar.lineTo(left + length, base - Painting.px(TICK));
        g.draw(bar);
        g.drawString(text, (float) left + 5, (float) (base - Painting.px(TICK)));
        north(paint, margin + Painting.px(9), base);
        if (!attribution.isEmpty()) {
            Rectangle2D size = paint.plate(attribution, 0, 0);
            paint.write(
                    attribution,
                    paint.plate(attribution, frame.width() - size.getWidth() - margin, base - size.getHeight()));
        }
    }

    private static String plain(double metres) {
        return metres >= 1000
                ? Math.round(metres / 1000) + " km"
                : GeoMeasure.length(Math.rint(metres)).replace(".0", "");
    }

    private static void north(MapPaint paint, double middle, double base) {
        Graphics2D g = paint.g();
        double half = Painting.px(5);
        double high = Painting.px(ARROW);
        Path2D arrow = new Path2D.Double();
        arrow.moveTo(middle, base - high);
        arrow.lineTo(middle + half, base);
        arrow.lineTo(middle, base - Painting.px(4));
        arrow.lineTo(middle - half, base);
        arrow.closePath();
        g.fill(arrow);
        g.drawString("N", (float) (middle + half + 2), (float)
                (base - high + g.getFontMetrics().getAscent() / 2.0));
    }
}
