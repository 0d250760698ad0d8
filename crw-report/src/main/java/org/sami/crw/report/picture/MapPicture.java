package org.sami.crw.report.picture;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.Shape;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.Locale;
import java.util.stream.Collectors;
import org.sami.crw.report.Exploration;
import org.sami.crw.report.ReportWords;
import org.sami.crw.report.RunHeader;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.RunResult;

/**
 * The picture of a run: tracks, locations, areas and points of the plan, quay, start and end of each boat, with meridians and
 * parallels, scale bar, north arrow and legend, and in words why a run did not end. Drawn in memory; needs no display.
 */
public final class MapPicture {
    private static final int WIDTH = 1480;
    private static final int HEIGHT = 1080;
    private static final int LEFT = 104;
    private static final int MAP_WIDTH = 960;
    private static final int WHY_LINES = 4;

    private final RunReport report;

    /** The map of a run. */
    public MapPicture(RunReport report) {
        this.report = report;
    }

    /**
     * Makes the platform ready to draw. At their first use its fonts and image writers want a word at the end of the process, and a
     * process that is ending already refuses them: the picture of a run that Ctrl-C stops could not be drawn.
     */
    public static void prepare() throws IOException {
        PngPicture.of(16, 16, g -> {
            g.setFont(DrawnText.font(Font.PLAIN, 12));
            g.drawString("N", 1, 14);
        });
    }

    /** The map as a PNG file's content. */
    public byte[] png() throws IOException {
        return PngPicture.of(WIDTH, HEIGHT, this::draw);
    }

    private void draw(Graphics2D g) {
        g.setColor(MapColors.PAPER);
        g.fillRect(0, 0, WIDTH, HEIGHT);
        int top = title(g) + 18;
        Rectangle map = new Rectangle(LEFT, top, MAP_WIDTH, HEIGHT - 76 - top);
        MapScale scale = MapScale.fitting(report, map);
        g.setColor(MapColors.WATER);
        g.fill(map);
        AreaDrawing.draw(g, report, map, scale);
        new GraticuleDrawing(map, scale, report.header().place().centre()).draw(g);
        square(g, map, scale);
        new FleetDrawing(report, map, scale).draw(g);
        g.setColor(MapColors.FAINT_INK);
        g.setStroke(MapColors.dashed(1.2f));
        g.draw(map);
        below(g, map, scale);
        int legend = LEFT + MAP_WIDTH + 32;
        new LegendDrawing(report, new Rectangle(legend, top, WIDTH - 32 - legend, HEIGHT - 24 - top)).draw(g);
    }

    /** Scale bar and north arrow, below the map: on it they would cover something. */
    static void below(Graphics2D g, Rectangle map, MapScale scale) {
        double metres = scale.roundMetres(220);
        double length = scale.pixels(metres);
        int y = (int) map.getMaxY() + 48;
        g.setColor(MapColors.INK);
        g.fill(new Rectangle2D.Double(map.x, y - 4, length / 2, 7));
        g.setStroke(MapColors.dashed(1.2f));
        g.draw(new Rectangle2D.Double(map.x, y - 4, length, 7));
        g.setFont(DrawnText.font(Font.BOLD, 15));
        String label = metres >= 1 ? String.valueOf(Math.round(metres)) : String.valueOf(metres);
        g.drawString(label + " m", (float) (map.x + length + 12), y + 5);
        MapSymbols.north(g, new Point2D.Double(map.getMaxX() - 16, y));
    }

    /** Where the simulated operator put the locations; only the part of it that is on the map. */
    private void square(Graphics2D g, Rectangle map, MapScale scale) {
        if (report.locations().isEmpty()) {
            return;
        }
        double areaM = report.header().areaM();
        double side = scale.pixels(areaM);
        Shape before = g.getClip();
        g.clip(map);
        g.setColor(MapColors.FAINT_INK);
        g.setStroke(MapColors.dashed(1.2f, 6, 6));
        g.draw(new Rectangle2D.Double(scale.x(-areaM / 2), scale.y(areaM / 2), side, side));
        g.setClip(before);
    }

    /** What was run, how it came out, and why it did not end where it did not. Returns where it ends. */
    private int title(Graphics2D g) {
        g.setColor(MapColors.INK);
        g.setFont(DrawnText.font(Font.BOLD, 26));
        int width = WIDTH - LEFT - 32;
        g.drawString(DrawnText.fitting(report.header().planName(), g.getFontMetrics(), width), LEFT, 44);
        g.setColor(MapColors.FAINT_INK);
        g.setFont(DrawnText.font(Font.PLAIN, 16));
        g.drawString(DrawnText.fitting(summary(), g.getFontMetrics(), width), LEFT, 74);
        g.setColor(MapColors.FAULT);
        int y = 74;
        for (String line : DrawnText.lines(why(), g.getFontMetrics(), width, WHY_LINES)) {
            y += 24;
            g.drawString(line, LEFT, y);
        }
        return y;
    }

    private String summary() {
        RunHeader header = report.header();
        RunResult result = report.result();
        StringBuilder text = new StringBuilder();
        text.append("plan ")
                .append(header.plan())
                .append(" · seed ")
                .append(header.seed())
                .append(" · ");
        text.append(
                result.outcome() == RunOutcome.RUNNING
                        ? "still running"
                        : result.outcome().word());
        text.append(" after ").append(ReportWords.duration(result.simulatedMillis()));
        if (!report.locations().isEmpty()) {
            text.append(" · ").append(report.locationsVisited()).append(" of ");
            text.append(report.locations().size()).append(" locations visited");
        }
        for (Exploration explored : report.map().explorations()) {
            double part = explored.uncoveredM2() / Math.max(1e-9, explored.areaM2());
            text.append(String.format(Locale.ROOT, " · %.1f %% explored", 100 * (1 - part)));
        }
        report.origin().ifPresent(origin -> text.append(" · started ").append(ReportWords.moment(origin)));
        return text.toString();
    }

    private String why() {
        RunResult result = report.result();
        if (result.outcome() == RunOutcome.ENDED) {
            return result.reason();
        }
        String reason = result.reason().isEmpty()
                ? result.outcome() == RunOutcome.RUNNING ? "Stopped before the mission was over." : ""
                : "Why: " + result.reason() + ".";
        String waits = result.outcome() != RunOutcome.FAILED
                ? ""
                : report.waits().stream()
                        .map(wait -> " "
                                + String.join(". ", wait.lines())
                                        .replace("..", ".")
                                        .replaceAll("\\s+", " "))
                        .collect(Collectors.joining());
        return (reason + waits).strip();
    }
}
