package org.sami.crw.report.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.Locale;
import java.util.stream.Stream;
import org.sami.crw.report.DepthsPart;
import org.sami.crw.report.DepthsPart.DepthCell;
import org.sami.crw.report.RunReport;

/**
 * The map of the depths that were measured: squares in steps of blue, the darker the deeper, with meridians and parallels, scale bar, north arrow, and a legend in
 * metres. Squares whose depth is that between measured ones are hatched. Drawn in memory; needs no display.
 */
public final class DepthPicture {
    private static final int WIDTH = 1240;
    private static final int HEIGHT = 960;
    private static final int MOST_STEPS = 8;
    private static final int SWATCH = 34;
    private static final Rectangle MAP = new Rectangle(104, 104, 840, 780);
    private static final int LEGEND = MAP.x + MAP.width + 36;
    private static final Color SHALLOW = new Color(0xe3, 0xf4, 0xdf);
    private static final Color MIDDLE = new Color(0x3f, 0x9f, 0xc4);
    private static final Color DEEP = new Color(0x08, 0x1d, 0x58);
    private static final Color HATCH = new Color(255, 255, 255, 150);

    private final RunReport report;
    private final DepthsPart depths;
    private final double stepM;
    private final double leastM; // shallow end of the first step

    /** The map of what a run measured. */
    public DepthPicture(RunReport report, DepthsPart depths) {
        this.report = report;
        this.depths = depths;
        stepM = stepM(depths.leastM(), depths.mostM());
        leastM = Math.floor(depths.leastM() / stepM) * stepM;
    }

    /** The map as a PNG file's content. */
    public byte[] png() throws IOException {
        return PngPicture.of(WIDTH, HEIGHT, this::draw);
    }

    private void draw(Graphics2D g) {
        g.setColor(MapColors.PAPER);
        g.fillRect(0, 0, WIDTH, HEIGHT);
        title(g);
        double half = depths.cellM() / 2;
        MapScale scale = MapScale.fitting(
                depths.cells().stream()
                        .map(DepthCell::middle)
                        .flatMap(at -> Stream.of(
                                new Point2D.Double(at.eastM() - half, at.northM() - half),
                                new Point2D.Double(at.eastM() + half, at.northM() + half))),
                MAP);
        squares(g, scale);
        new GraticuleDrawing(MAP, scale, report.header().place().centre()).draw(g);
        g.setColor(MapColors.FAINT_INK);
        g.setStroke(MapColors.dashed(1.2f));
        g.draw(MAP);
        MapPicture.below(g, MAP, scale);
        legend(g);
    }

    private void title(Graphics2D g) {
        g.setColor(MapColors.INK);
        g.setFont(DrawnText.font(Font.BOLD, 24));
        String title = "Measured depths: " + report.header().planName();
        g.drawString(DrawnText.fitting(title, g.getFontMetrics(), WIDTH - MAP.x - 32), MAP.x, 44);
        g.setColor(MapColors.FAINT_INK);
        g.setFont(DrawnText.font(Font.PLAIN, 16));
        String summary = String.format(
                Locale.ROOT,
                "%.1f to %.1f m · %d squares of %.0f m · %d readings%s",
                depths.leastM(),
                depths.mostM(),
                depths.cells().size(),
                depths.cellM(),
                depths.readings(),
                depths.error()
                        .map(off -> String.format(
                                Locale.ROOT, " · error: mean %.2f m, 95 of 100 within %.2f m", off.meanM(), off.p95M()))
                        .orElse(""));
        g.drawString(DrawnText.fitting(summary, g.getFontMetrics(), WIDTH - MAP.x - 32), MAP.x, 76);
    }

    private void squares(Graphics2D g, MapScale scale) {
        Shape before = g.getClip();
        g.clip(MAP);
        double half = depths.cellM() / 2;
        for (DepthCell cell : depths.cells()) {
            double west = scale.x(cell.middle().eastM() - half);
            double north = scale.y(cell.middle().northM() + half);
            double east = scale.x(cell.middle().eastM() + half);
            double south = scale.y(cell.middle().northM() - half);
            g.setColor(color((int) Math.floor((cell.depthM() - leastM) / stepM)));
            // whole pixels: squares side by side leave no line between them
            g.fillRect(
                    (int) Math.floor(west),
                    (int) Math.floor(north),
                    (int) Math.floor(east) - (int) Math.floor(west),
                    (int) Math.floor(south) - (int) Math.floor(north));
            if (cell.readings() == 0) {
                hatch(g, new Rectangle2D.Double(west, north, east - west, south - north));
            }
        }
        g.setClip(before);
    }

    /** Says of a square that its depth lies between measured ones. */
    private static void hatch(Graphics2D g, Rectangle2D square) {
        g.setColor(HATCH);
        g.setStroke(new BasicStroke(1.4f));
        g.draw(new Line2D.Double(square.getX(), square.getMaxY(), square.getMaxX(), square.getY()));
    }

    private void legend(Graphics2D g) {
        g.setColor(MapColors.INK);
        g.setFont(DrawnText.font(Font.BOLD, 18));
        g.drawString("Depth in metres", LEGEND, MAP.y + 18);
        g.setFont(DrawnText.font(Font.PLAIN, 15));
        int y = MAP.y + 40;
        for (int step = 0; step < steps(); step++) {
            Rectangle2D swatch = new Rectangle2D.Double(LEGEND, y, SWATCH * 1.4, SWATCH);
            g.setColor(color(step));
            g.fill(swatch);
            g.setColor(MapColors.FAINT_INK);
            g.setStroke(MapColors.dashed(0.8f));
            g.draw(swatch);
            g.setColor(MapColors.INK);
            String format = stepM < 1 ? "%.1f to %.1f" : "%.0f to %.0f";
            g.drawString(
                    String.format(Locale.ROOT, format, leastM + step * stepM, leastM + (step + 1) * stepM),
                    (float) (LEGEND + SWATCH * 1.4 + 14),
                    y + SWATCH / 2f + 5);
            y += SWATCH;
        }
        if (depths.cells().stream().anyMatch(cell -> cell.readings() == 0)) {
            Rectangle2D swatch = new Rectangle2D.Double(LEGEND, y + 14, SWATCH * 1.4, SWATCH);
            g.setColor(color(steps() / 2));
            g.fill(swatch);
            hatch(g, swatch);
            g.setColor(MapColors.INK);
            g.drawString("between readings", (float) (LEGEND + SWATCH * 1.4 + 14), y + 14 + SWATCH / 2f + 5);
            y += 14 + SWATCH;
        }
        g.setColor(MapColors.FAINT_INK);
        g.drawString("no colour: not measured", LEGEND, y + 28);
    }

    private int steps() {
        return Math.max(1, (int) Math.floor((depths.mostM() - leastM) / stepM) + 1);
    }

    private Color color(int step) {
        double part = steps() < 2 ? 0.5 : (double) step / (steps() - 1);
        return part < 0.5 ? mixed(SHALLOW, MIDDLE, part * 2) : mixed(MIDDLE, DEEP, part * 2 - 1);
    }

    private static Color mixed(Color from, Color to, double part) {
        return new Color(
                (int) Math.round(from.getRed() + part * (to.getRed() - from.getRed())),
                (int) Math.round(from.getGreen() + part * (to.getGreen() - from.getGreen())),
                (int) Math.round(from.getBlue() + part * (to.getBlue() - from.getBlue())));
    }

    /** The least of 0.1, 0.2, 0.5, 1, 2, 5 ... metres with which few steps suffice. */
    private static double stepM(double least, double most) {
        double power = 0.1;
        while (true) {
            for (double digit : new double[] {1, 2, 5}) {
                double step = digit * power;
                if (Math.floor(most / step) - Math.floor(least / step) < MOST_STEPS) {
                    return step;
                }
            }
            power *= 10;
        }
    }
}
