package org.sami.ui.map;

import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import org.sami.palette.SemanticColor;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;

/** Paths on which vehicles are expected: long dashes on a light ground, a ring at the end, and a label next to the longest leg. */
public final class ExpectedPathLayer extends MapLayer {
    private static final double RING_PX = 7;
    private static final double REACH_PX = 6;
    private static final double DASH_PX = 14;
    private static final double GAP_PX = 7;

    private record Shown(ExpectedPath path, WorldLine line) {}

    private List<Shown> paths = List.of();

    public ExpectedPathLayer(String id, String title) {
        super(id, title);
    }

    /** Shows these paths instead of those before. */
    public void show(List<ExpectedPath> next) {
        if (!next.equals(paths())) {
            paths = next.stream()
                    .filter(path -> path.points().size() > 1)
                    .map(path -> new Shown(path, new WorldLine(path.points())))
                    .toList();
            changed();
        }
    }

    /** The paths that are shown. */
    public List<ExpectedPath> paths() {
        return paths.stream().map(Shown::path).toList();
    }

    @Override
    protected void paint(MapPaint paint) {
        paths.stream()
                .filter(shown -> shown.line().isNear(paint.frame()))
                .forEach(shown -> paint.paint(shown.path().id(), () -> paint(paint, shown)));
    }

    private static void paint(MapPaint paint, Shown shown) {
        WorldLine line = shown.line();
        Graphics2D g = paint.g();
        g.setColor(SemanticColor.MAP_HALO.get());
        g.setStroke(Painting.dashed(5, DASH_PX, GAP_PX));
        g.draw(line.path(paint.frame()));
        g.setColor(shown.path().mark().color());
        g.setStroke(Painting.dashed(2.5, DASH_PX, GAP_PX));
        g.draw(line.path(paint.frame()));
        double x = line.px(paint.frame(), line.size() - 1);
        double y = line.py(paint.frame(), line.size() - 1);
        double ring = Painting.px(RING_PX);
        g.setStroke(Painting.line(2.5));
        g.draw(new Ellipse2D.Double(x - ring, y - ring, 2 * ring, 2 * ring));
    }

    @Override
    protected void paintNames(MapPaint paint) {
        paths.stream()
                .filter(shown -> shown.line().isNear(paint.frame()))
                .forEach(shown -> paint.paint(shown.path().id(), () -> write(paint, shown)));
    }

    /** Next to the middle of the longest leg. */
    private static void write(MapPaint paint, Shown shown) {
        WorldLine line = shown.line();
        MapFrame frame = paint.frame();
        int longest = 1;
        for (int leg = 2; leg < line.size(); leg++) {
            if (lengthPx(line, frame, leg) > lengthPx(line, frame, longest)) {
                longest = leg;
            }
        }
        double x = (line.px(frame, longest - 1) + line.px(frame, longest)) / 2;
        double y = (line.py(frame, longest - 1) + line.py(frame, longest)) / 2;
        paint.font(MapPaint.PLAIN);
        Rectangle2D size = paint.plate(shown.path().text(), 0, 0);
        double w = size.getWidth();
        double h = size.getHeight();
        double apart = Painting.px(RING_PX);
        paint.writeName(
                shown.path().text(),
                x + apart,
                y - h / 2,
                x - apart - w,
                y - h / 2,
                x - w / 2,
                y + apart,
                x - w / 2,
                y - apart - h);
    }

    private static double lengthPx(WorldLine line, MapFrame frame, int leg) {
        return Math.hypot(line.px(frame, leg) - line.px(frame, leg - 1), line.py(frame, leg) - line.py(frame, leg - 1));
    }

    @Override
    public Optional<GeoBounds> bounds() {
        return paths.stream().flatMap(shown -> shown.line().bounds().stream()).reduce(GeoBounds::with);
    }

    @Override
    public Optional<String> textAt(MapFrame frame, double px, double py) {
        return paths.stream()
                .filter(shown -> shown.line().distancePx(frame, px, py) <= REACH_PX)
                .map(shown -> shown.path().text())
                .findFirst();
    }
}
