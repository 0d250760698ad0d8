package org.sami.crw.sim.report;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.Locale;

/** The panel beside the map: who is who, what the signs mean, how the run came out. */
final class LegendDrawing {
    private final RunReport report;
    private final Rectangle frame;
    private int y;

    LegendDrawing(RunReport report, Rectangle frame) {
        this.report = report;
        this.frame = frame;
    }

    void draw(Graphics2D g) {
        y = frame.y + 18;
        heading(g, "Boats");
        boats(g);
        y += 22;
        heading(g, "Signs");
        signs(g);
        y += 22;
        heading(g, "Run");
        run(g);
    }

    private void heading(Graphics2D g, String text) {
        g.setColor(Palette.INK);
        g.setFont(MapPicture.font(Font.BOLD, 19));
        g.drawString(text, frame.x, y);
        g.setColor(Palette.GRID);
        g.setStroke(Palette.dashed(1.5f));
        g.draw(new Line2D.Double(frame.x, y + 8, frame.getMaxX(), y + 8));
        y += 34;
    }

    private void boats(Graphics2D g) {
        List<BoatResult> boats = report.boats();
        int shown = Math.min(boats.size(), 16);
        int step = shown > 8 ? 24 : 42;
        for (int i = 0; i < shown; i++) {
            BoatResult boat = boats.get(i);
            g.setColor(Palette.color(i));
            g.setStroke(Palette.line(i));
            g.draw(new Line2D.Double(frame.x + 2, y - 5, frame.x + 54, y - 5));
            g.setColor(Palette.INK);
            g.setFont(MapPicture.font(Font.BOLD, 15));
            g.drawString(boat.id(), frame.x + 68, y);
            g.setFont(MapPicture.font(Font.PLAIN, 15));
            String travelled =
                    String.format(Locale.ROOT, "%.0f m · battery %.0f %%", boat.distanceM(), boat.batteryPercent());
            if (step > 24) {
                g.drawString(travelled + " · " + visits(boat), frame.x + 68, y + 18);
            } else {
                g.drawString(travelled, frame.x + 168, y);
            }
            y += step;
        }
        if (shown < boats.size()) {
            g.setFont(MapPicture.font(Font.ITALIC, 15));
            g.drawString("and " + (boats.size() - shown) + " more (boats.csv)", frame.x + 68, y);
            y += 24;
        }
    }

    private String visits(BoatResult boat) {
        long visits = report.locations().stream()
                .filter(location -> location.visitedBy().equals(boat.id()))
                .count();
        return visits + (visits == 1 ? " location" : " locations");
    }

    private void signs(Graphics2D g) {
        FleetDrawing.Signs.location(g, sign(), "1", Palette.color(0), FleetDrawing.Signs.LOCATION_RADIUS);
        text(g, "location, visited, in its visitor's colour");
        FleetDrawing.Signs.location(g, sign(), "2", null, FleetDrawing.Signs.LOCATION_RADIUS);
        text(g, "location, not visited");
        FleetDrawing.Signs.start(g, sign(), Palette.color(0));
        text(g, "start of a boat");
        FleetDrawing.Signs.boat(g, sign(), 0, Palette.color(0));
        text(g, "boat at the end of the run");
        g.setColor(Palette.FAINT_INK);
        g.setStroke(Palette.dashed(1.2f, 6, 6));
        g.draw(new java.awt.geom.Rectangle2D.Double(frame.x + 8, y - 17, 24, 24));
        text(g, "area of the locations");
    }

    private Point2D sign() {
        return new Point2D.Double(frame.x + 20.0, y - 5.0);
    }

    private void text(Graphics2D g, String text) {
        g.setColor(Palette.INK);
        g.setFont(MapPicture.font(Font.PLAIN, 15));
        g.drawString(text, frame.x + 48, y);
        y += 36;
    }

    private void run(Graphics2D g) {
        RunResult result = report.result();
        pair(g, "outcome", result.outcome().word());
        pair(g, "simulated time", ReportText.duration(result.simulatedMillis()));
        pair(g, "distance", String.format(Locale.ROOT, "%.0f m", report.distanceM()));
        pair(g, "operator's clicks", String.valueOf(result.clicks()));
        pair(g, "firings", String.valueOf(result.firings()));
        pair(g, "seed", String.valueOf(report.header().seed()));
    }

    private void pair(Graphics2D g, String name, String value) {
        g.setFont(MapPicture.font(Font.PLAIN, 15));
        g.setColor(Palette.FAINT_INK);
        g.drawString(name, frame.x, y);
        g.setColor(Palette.INK);
        g.drawString(value, frame.x + 168, y);
        y += 25;
    }
}
