package org.sami.crw.report.picture;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Locale;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.MapArea;
import org.sami.crw.report.MapNames;
import org.sami.crw.report.MapSpot;
import org.sami.crw.report.ReportWords;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.RunResult;

/** The panel next to the map: the boats, the signs, the run's outcome. */
final class LegendDrawing {
    /** Headings, gaps and the lines below "Run". */
    private static final int RUN_HEIGHT = 3 * 32 + 2 * 18 + 18 + 9 * 24;

    private static final int SIGN_HEIGHT = 31;
    private static final int TWO_LINES = 42;
    private static final int ONE_LINE = 20;

    private final RunReport report;
    private final Rectangle frame;
    private int y;

    LegendDrawing(RunReport report, Rectangle frame) {
        this.report = report;
        this.frame = frame;
    }

    void draw(Graphics2D g) {
        y = frame.y + 18;
        heading(g, say("Boats"));
        boats(g);
        y += 18;
        heading(g, "Signs");
        signs(g);
        y += 18;
        heading(g, "Run");
        run(g);
    }

    private String say(String text) {
        return report.header().robots().say(text);
    }

    private void heading(Graphics2D g, String text) {
        g.setColor(MapColors.INK);
        g.setFont(DrawnText.font(Font.BOLD, 19));
        g.drawString(text, frame.x, y);
        g.setColor(MapColors.GRID);
        g.setStroke(MapColors.dashed(1.5f));
        g.draw(new Line2D.Double(frame.x, y + 8, frame.getMaxX(), y + 8));
        y += 32;
    }

    private void boats(Graphics2D g) {
        List<BoatResult> boats = report.boats();
        int room = frame.height - RUN_HEIGHT - SIGN_HEIGHT * signCount();
        int step = boats.size() * TWO_LINES <= room ? TWO_LINES : ONE_LINE;
        int shown = boats.size() * step <= room ? boats.size() : Math.max(1, room / step - 1);
        for (int i = 0; i < shown; i++) {
            BoatResult boat = boats.get(i);
            MapColors.track(g, new Line2D.Double(frame.x + 2, y - 5, frame.x + 54, y - 5), boat.mark());
            g.setColor(MapColors.INK);
            String travelled =
                    String.format(Locale.ROOT, "%.0f m · battery %.0f %%", boat.distanceM(), boat.batteryPercent());
            boolean twoLines = step == TWO_LINES;
            words(g, Font.BOLD, boat.id(), 68, y, twoLines ? frame.width - 68 : 96);
            words(
                    g,
                    Font.PLAIN,
                    twoLines ? travelled + visits(boat) : travelled,
                    twoLines ? 68 : 168,
                    y + (twoLines ? 18 : 0),
                    400);
            y += step;
        }
        if (shown < boats.size()) {
            words(g, Font.ITALIC, "and " + (boats.size() - shown) + " more (boats.csv)", 68, y, 400);
            y += ONE_LINE;
        }
    }

    private String visits(BoatResult boat) {
        if (report.locations().isEmpty()) {
            return "";
        }
        long visits = report.visitsBy(boat.id());
        return " · " + visits + (visits == 1 ? " location" : " locations");
    }

    /** Those that are on the map. */
    private void signs(Graphics2D g) {
        if (report.locations().stream().anyMatch(LocationResult::visited)) {
            MapSymbols.location(g, sign(), "1", MapColors.color(0), MapSymbols.LOCATION_RADIUS);
            text(g, "location, visited, in its visitor's colour");
        }
        if (!report.locations().stream().allMatch(LocationResult::visited)) {
            MapSymbols.location(g, sign(), "2", null, MapSymbols.LOCATION_RADIUS);
            text(g, "location, not visited");
        }
        if (!report.locations().isEmpty()) {
            g.setColor(MapColors.FAINT_INK);
            g.setStroke(MapColors.dashed(1.2f, 6, 6));
            g.draw(new Rectangle2D.Double(frame.x + 8, y - 17, 24, 24));
            text(g, "square in which locations are drawn");
        }
        MapSymbols.start(g, sign(), MapColors.color(0));
        text(g, say("start of a boat"));
        MapSymbols.boat(g, sign(), 0, MapColors.color(0));
        text(g, say("boat at the end of the run"));
        if (report.header().place().quay().isPresent()) {
            MapSymbols.quay(g, sign());
            text(g, say("quay"));
        }
        if (has(MapSpot.Kind.PLAN)) {
            MapSymbols.planPoint(g, sign());
            text(g, MapSpot.Kind.PLAN.words());
        }
        if (has(MapSpot.Kind.ASSEMBLY)) {
            MapSymbols.assembly(g, sign(), MapColors.color(0));
            text(g, say("assembly place, in its boat's colour"));
        }
        if (report.map().closest().underWay().isPresent()) {
            MapSymbols.approach(g, sign());
            text(g, "closest approach under way");
        }
        for (MapArea.Kind kind : kinds()) {
            AreaDrawing.area(g, kind, new Rectangle2D.Double(frame.x + 6, y - 16, 28, 22));
            text(g, kind.words());
        }
    }

    private int signCount() {
        boolean visited = report.locations().stream().anyMatch(LocationResult::visited);
        boolean unvisited = !report.locations().stream().allMatch(LocationResult::visited);
        return (visited ? 1 : 0)
                + (unvisited ? 1 : 0)
                + (report.locations().isEmpty() ? 0 : 1)
                + 2
                + (report.header().place().quay().isPresent() ? 1 : 0)
                + (has(MapSpot.Kind.PLAN) ? 1 : 0)
                + (has(MapSpot.Kind.ASSEMBLY) ? 1 : 0)
                + (report.map().closest().underWay().isPresent() ? 1 : 0)
                + kinds().size();
    }

    private boolean has(MapSpot.Kind kind) {
        return report.map().spots().stream().anyMatch(spot -> spot.kind() == kind);
    }

    private List<MapArea.Kind> kinds() {
        return MapNames.areas(report).stream()
                .map(MapArea::kind)
                .distinct()
                .sorted()
                .toList();
    }

    private Point2D sign() {
        return new Point2D.Double(frame.x + 20.0, y - 5.0);
    }

    private void text(Graphics2D g, String text) {
        g.setColor(MapColors.INK);
        words(g, Font.PLAIN, text, 48, y, frame.width - 48);
        y += SIGN_HEIGHT;
    }

    private void words(Graphics2D g, int style, String text, int x, int atY, int width) {
        g.setFont(DrawnText.font(style, 15));
        g.drawString(DrawnText.fitting(text, g.getFontMetrics(), Math.min(width, frame.width - x)), frame.x + x, atY);
    }

    private void run(Graphics2D g) {
        RunResult result = report.result();
        pair(g, "outcome", result.outcome().word());
        pair(g, "simulated time", ReportWords.duration(result.simulatedMillis()));
        pair(g, "distance", String.format(Locale.ROOT, "%.0f m", report.distanceM()));
        report.map().closest().underWay().ifPresent(near -> {
            String when = ReportWords.duration(near.atMillis());
            pair(g, "closest approach", String.format(Locale.ROOT, "%.1f m at %s", near.distanceM(), when));
            pair(g, "", near.boat() + " and " + near.other());
        });
        pair(g, "operator's clicks", String.valueOf(result.clicks()));
        pair(g, "firings", String.valueOf(result.firings()));
        pair(g, "plan hash", report.header().planHash().substring(0, 16));
        report.origin().ifPresent(origin -> pair(g, "program", "crw " + origin.version()));
    }

    private void pair(Graphics2D g, String name, String value) {
        g.setColor(MapColors.FAINT_INK);
        words(g, Font.PLAIN, name, 0, y, 145);
        g.setColor(MapColors.INK);
        words(g, Font.PLAIN, value, 148, y, frame.width - 148);
        y += 24;
    }
}
