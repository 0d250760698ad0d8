package org.sami.crw.report.picture;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.Locale;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.report.MapPoint;

/** Meridians and parallels over the map, with degrees along its edges. */
final class GraticuleDrawing {
    private static final double LINE_SPACING_PIXELS = 170;

    private final Rectangle frame;
    private final MapScale scale;
    private final LocalFrame plane;

    GraticuleDrawing(Rectangle frame, MapScale scale, MapPoint centre) {
        this.frame = frame;
        this.scale = scale;
        plane = new LocalFrame(centre.latDeg(), centre.lonDeg());
    }

    void draw(Graphics2D g) {
        g.setFont(DrawnText.font(Font.PLAIN, 13));
        g.setStroke(MapColors.dashed(1));
        meridians(g);
        parallels(g);
    }

    private void meridians(Graphics2D g) {
        double west = lon(scale.westM());
        double span = Math.IEEEremainder(lon(scale.eastM()) - west, 360);
        double step = step(span, frame.width);
        FontMetrics metrics = g.getFontMetrics();
        for (double n = Math.ceil(west / step); n * step <= west + span; n++) {
            double lonDeg = Math.IEEEremainder(n * step, 360);
            double bottom = scale.x(plane.eastM(plane.latDeg(0, scale.southM()), lonDeg));
            double top = scale.x(plane.eastM(plane.latDeg(0, scale.northM()), lonDeg));
            g.setColor(MapColors.GRID);
            g.draw(new Line2D.Double(bottom, frame.getMaxY(), top, frame.y));
            String label = degrees(lonDeg, step, "E", "W");
            g.setColor(MapColors.FAINT_INK);
            g.drawString(label, (float) (bottom - metrics.stringWidth(label) / 2.0), (float) frame.getMaxY() + 20);
        }
    }

    private void parallels(Graphics2D g) {
        double south = plane.latDeg(0, scale.southM());
        double north = plane.latDeg(0, scale.northM());
        double step = step(north - south, frame.height);
        FontMetrics metrics = g.getFontMetrics();
        for (double n = Math.ceil(south / step); n * step <= north; n++) {
            double latDeg = n * step;
            double left = scale.y(plane.northM(latDeg, lon(scale.westM())));
            double right = scale.y(plane.northM(latDeg, lon(scale.eastM())));
            g.setColor(MapColors.GRID);
            g.draw(new Line2D.Double(frame.x, left, frame.getMaxX(), right));
            String label = degrees(latDeg, step, "N", "S");
            g.setColor(MapColors.FAINT_INK);
            g.drawString(label, frame.x - 8 - metrics.stringWidth(label), (float) left + 5);
        }
    }

    private double lon(double eastM) {
        return plane.lonDeg(eastM, (scale.southM() + scale.northM()) / 2);
    }

    /** 1, 2 or 5 at some digit, about so many degrees as lie between two lines. */
    private static double step(double spanDeg, int pixels) {
        double wanted = spanDeg * LINE_SPACING_PIXELS / pixels;
        double power = Math.pow(10, Math.floor(Math.log10(wanted)));
        double digit = wanted / power;
        return (digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power;
    }

    private static String degrees(double value, double step, String above, String below) {
        int digits = (int) Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
        String number = String.format(Locale.ROOT, "%." + digits + "f", Math.abs(value));
        return number + "\u00b0 " + (value >= 0 ? above : below);
    }
}
