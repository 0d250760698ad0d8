package org.sami.crw.sim.report;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Locale;
import javax.imageio.ImageIO;

/**
 * The picture of a run: tracks, locations, start and end of each boat, with scale bar, north arrow and legend. Drawn in
 * memory; needs no display.
 */
final class MapPicture {
    private static final int WIDTH = 1480;
    private static final int HEIGHT = 1080;
    private static final Rectangle MAP = new Rectangle(64, 96, 1000, 916);
    private static final Rectangle LEGEND = new Rectangle(1096, 96, 352, 916);

    private final RunReport report;

    MapPicture(RunReport report) {
        this.report = report;
    }

    /**
     * Makes the platform ready to draw. At their first use its fonts and image writers want a word at the end of the process, and a
     * process that is ending already refuses them: the picture of a run that Ctrl-C stops could not be drawn.
     */
    static void prepare() throws IOException {
        BufferedImage image = new BufferedImage(16, 16, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        try {
            g.setFont(font(Font.PLAIN, 12));
            g.drawString("N", 1, 14);
        } finally {
            g.dispose();
        }
        ImageIO.write(image, "png", new ByteArrayOutputStream());
    }

    byte[] png() throws IOException {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        try {
            g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
            g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
            draw(g);
        } finally {
            g.dispose();
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(image, "png", bytes);
        return bytes.toByteArray();
    }

    private void draw(Graphics2D g) {
        g.setColor(Palette.PAPER);
        g.fillRect(0, 0, WIDTH, HEIGHT);
        title(g);
        MapScale scale = MapScale.fitting(report, MAP);
        new WaterDrawing(MAP, scale, report.header().areaM()).draw(g);
        new FleetDrawing(report, MAP, scale).draw(g);
        new LegendDrawing(report, LEGEND).draw(g);
    }

    private void title(Graphics2D g) {
        RunHeader header = report.header();
        RunResult result = report.result();
        g.setColor(Palette.INK);
        g.setFont(font(Font.BOLD, 26));
        g.drawString(header.planName(), MAP.x, 44);
        g.setColor(Palette.FAINT_INK);
        g.setFont(font(Font.PLAIN, 16));
        String line = String.format(
                Locale.ROOT,
                "plan %s · seed %d · mission %s after %s of simulated time · %d of %d locations visited",
                header.plan(),
                header.seed(),
                result.outcome() == RunOutcome.RUNNING
                        ? "still running"
                        : result.outcome().word(),
                ReportText.duration(result.simulatedMillis()),
                report.locationsVisited(),
                report.locations().size());
        g.drawString(line, MAP.x, 74);
    }

    static Font font(int style, int size) {
        return new Font(Font.SANS_SERIF, style, size);
    }
}
