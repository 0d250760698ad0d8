package org.sami.crw.report.picture;

import java.awt.BasicStroke;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/**
 * Box plots as a picture: one panel for each measure, in it a box for each configuration. A box spans the quartiles, its line is the median, the whiskers
 * end at the least and the greatest value; a ring is the published value.
 */
public final class BoxPlotPicture {
    private static final int LEFT = 70;
    private static final int RIGHT = 24;
    private static final int TITLE = 54;
    private static final int PANEL = 300;
    private static final int LABELS = 74;
    private static final int SLOT = 96;
    private static final int BOX = 34;
    private static final int LEAST_WIDTH = 560;
    private static final int RING = 10;

    private BoxPlotPicture() {}

    /**
     * A panel.
     *
     * @param title with the unit of the axis
     * @param boxes from left to right
     */
    public record Panel(String title, List<Box> boxes) {
        public Panel {
            boxes = List.copyOf(boxes);
        }
    }

    /**
     * A box.
     *
     * @param label of its configuration
     * @param quartiles least value, first quartile, median, third quartile, greatest value; empty where there are no values
     * @param published what was published; empty where nothing was
     */
    public record Box(String label, List<Double> quartiles, List<Double> published) {
        public Box {
            quartiles = List.copyOf(quartiles);
            published = List.copyOf(published);
        }
    }

    /** The content of a PNG file. */
    public static byte[] png(String title, List<Panel> panels) throws IOException {
        int most = panels.stream().mapToInt(panel -> panel.boxes().size()).max().orElse(0);
        int width = Math.max(LEAST_WIDTH, LEFT + RIGHT + most * SLOT);
        int height = TITLE + panels.size() * (PANEL + LABELS);
        return PngPicture.of(width, height, g -> {
            g.setColor(MapColors.PAPER);
            g.fillRect(0, 0, width, height);
            g.setColor(MapColors.INK);
            g.setFont(DrawnText.font(Font.BOLD, 16));
            g.drawString(DrawnText.fitting(title, g.getFontMetrics(), width - 2 * RIGHT), RIGHT, 32);
            for (int i = 0; i < panels.size(); i++) {
                panel(g, panels.get(i), TITLE + i * (PANEL + LABELS), width);
            }
        });
    }

    private static void panel(Graphics2D g, Panel panel, int top, int width) {
        double[] values = panel.boxes().stream()
                .flatMap(box -> Stream.concat(box.quartiles().stream(), box.published().stream()))
                .mapToDouble(Double::doubleValue)
                .toArray();
        double least = Math.min(0, DoubleStream.of(values).min().orElse(0));
        double most = Math.max(0, DoubleStream.of(values).max().orElse(1));
        double step = step(most - least);
        Axis axis = new Axis(Math.floor(least / step) * step, Math.ceil(most / step) * step, top + 34, top + PANEL - 6);
        g.setFont(DrawnText.font(Font.PLAIN, 13));
        g.setColor(MapColors.INK);
        g.drawString(panel.title(), RIGHT, top + 16);
        g.setFont(DrawnText.font(Font.PLAIN, 12));
        grid(g, axis, step, width);
        for (int i = 0; i < panel.boxes().size(); i++) {
            box(g, panel.boxes().get(i), axis, LEFT + i * SLOT + SLOT / 2);
        }
    }

    private record Axis(double least, double most, int topPx, int bottomPx) {
        double y(double value) {
            return bottomPx - (value - least) / Math.max(1e-9, most - least) * (bottomPx - topPx);
        }
    }

    /** A round distance of the axis's lines: 1, 2 or 5 times a power of ten. */
    private static double step(double range) {
        double wanted = Math.max(1e-6, range / 5);
        double power = Math.pow(10, Math.floor(Math.log10(wanted)));
        double times = wanted / power;
        return power * (times <= 1 ? 1 : times <= 2 ? 2 : times <= 5 ? 5 : 10);
    }

    private static void grid(Graphics2D g, Axis axis, double step, int width) {
        FontMetrics metrics = g.getFontMetrics();
        long lines = Math.round((axis.most() - axis.least()) / step);
        for (long i = 0; i <= lines; i++) {
            double value = axis.least() + i * step;
            double y = axis.y(value);
            boolean isZero = Math.abs(value) < step / 1000;
            g.setColor(isZero ? MapColors.INK : MapColors.GRID);
            g.setStroke(new BasicStroke(isZero ? 1.4f : 1));
            g.draw(new Line2D.Double(LEFT, y, width - RIGHT, y));
            String text = String.format(Locale.ROOT, step < 1 ? "%.1f" : "%.0f", isZero ? 0 : value);
            g.setColor(MapColors.FAINT_INK);
            g.drawString(text, LEFT - 8 - metrics.stringWidth(text), (float) y + 4);
        }
    }

    private static void box(Graphics2D g, Box box, Axis axis, int centre) {
        FontMetrics metrics = g.getFontMetrics();
        g.setColor(MapColors.INK);
        List<String> lines = DrawnText.lines(box.label(), metrics, SLOT - 8, 3);
        for (int i = 0; i < lines.size(); i++) {
            g.drawString(
                    lines.get(i),
                    centre - metrics.stringWidth(lines.get(i)) / 2,
                    axis.bottomPx() + 22 + i * metrics.getHeight());
        }
        if (!box.quartiles().isEmpty()) {
            drawn(g, box.quartiles(), axis, centre);
        }
        box.published().forEach(value -> {
            g.setColor(MapColors.FAULT);
            g.setStroke(new BasicStroke(2.2f));
            g.draw(new Ellipse2D.Double(centre + BOX / 2.0 + 6, axis.y(value) - RING / 2.0, RING, RING));
        });
    }

    private static void drawn(Graphics2D g, List<Double> quartiles, Axis axis, int centre) {
        double top = axis.y(quartiles.get(3));
        double bottom = axis.y(quartiles.get(1));
        Rectangle2D body = new Rectangle2D.Double(centre - BOX / 2.0, top, BOX, Math.max(1, bottom - top));
        g.setColor(MapColors.WATER);
        g.fill(body);
        g.setColor(MapColors.INK);
        g.setStroke(new BasicStroke(1.4f));
        g.draw(body);
        g.draw(new Line2D.Double(centre, top, centre, axis.y(quartiles.get(4))));
        g.draw(new Line2D.Double(centre, bottom, centre, axis.y(quartiles.get(0))));
        for (int end : List.of(0, 4)) {
            double y = axis.y(quartiles.get(end));
            g.draw(new Line2D.Double(centre - BOX / 4.0, y, centre + BOX / 4.0, y));
        }
        g.setStroke(new BasicStroke(2.6f));
        double median = axis.y(quartiles.get(2));
        g.draw(new Line2D.Double(centre - BOX / 2.0, median, centre + BOX / 2.0, median));
    }
}
