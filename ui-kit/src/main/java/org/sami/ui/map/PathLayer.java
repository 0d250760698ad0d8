package org.sami.ui.map;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.util.List;
import java.util.Optional;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Snapping;

/** Planned paths: thin, the current leg thick, the done part dashed. */
public final class PathLayer extends MapLayer {
    private static final double DOT_PX = 3;
    private static final double REACH_PX = 6;
    private static final double LEAST_LEG_PX = 8; // nearer points have no dots of their own
    private static final BasicStroke THIN = new BasicStroke(1.5f);
    private static final BasicStroke THICK = new BasicStroke(4, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    private static final BasicStroke DASHED =
            new BasicStroke(1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL, 10, new float[] {5, 5}, 0);

    private record Shown(PlannedPath path, WorldLine line) {}

    private List<Shown> paths = List.of();

    public PathLayer(String id, String title) {
        super(id, title);
    }

    /** Shows these paths instead of those before. */
    public void show(List<PlannedPath> paths) {
        List<Shown> before = this.paths;
        this.paths = paths.stream()
                .map(path -> before.stream()
                        .filter(shown -> shown.path().equals(path))
                        .findFirst()
                        .orElseGet(() -> new Shown(path, new WorldLine(path.points()))))
                .toList();
        changed();
    }

    @Override
    protected void paint(MapPaint paint) {
        paths.forEach(shown -> paint.paint(shown.path().id(), () -> paint(paint, shown)));
    }

    private static void paint(MapPaint paint, Shown shown) {
        WorldLine line = shown.line();
        MapFrame frame = paint.frame();
        Graphics2D g = paint.g();
        int last = line.size() - 1;
        if (last < 0) {
            return;
        }
        int next = shown.path().next();
        g.setColor(shown.path().mark().color());
        if (next >= 2) {
            g.setStroke(DASHED);
            g.draw(line.path(frame, 0, Math.min(next - 1, last)));
        }
        if (next >= 1 && next <= last) {
            g.setStroke(THICK);
            g.draw(line.path(frame, next - 1, next));
        }
        if (next < last) {
            g.setStroke(THIN);
            g.draw(line.path(frame, next, last));
        }
        dots(paint, line, next);
    }

    /** A filled dot for each point to come, a hollow one for each that is done. */
    private static void dots(MapPaint paint, WorldLine line, int next) {
        MapFrame frame = paint.frame();
        double lastX = Double.NEGATIVE_INFINITY;
        double lastY = Double.NEGATIVE_INFINITY;
        paint.g().setStroke(THIN);
        for (int i = 0; i < line.size(); i++) {
            double x = line.px(frame, i);
            double y = line.py(frame, i);
            if (Math.abs(x - lastX) + Math.abs(y - lastY) >= LEAST_LEG_PX || i == line.size() - 1) {
                Ellipse2D dot = new Ellipse2D.Double(x - DOT_PX, y - DOT_PX, 2 * DOT_PX, 2 * DOT_PX);
                if (i >= next) {
                    paint.g().fill(dot);
                } else {
                    paint.g().draw(dot);
                }
                lastX = x;
                lastY = y;
            }
        }
    }

    @Override
    public Optional<GeoBounds> bounds() {
        return paths.stream().flatMap(shown -> shown.line().bounds().stream()).reduce(GeoBounds::with);
    }

    @Override
    public Optional<String> itemAt(MapFrame frame, double px, double py) {
        return paths.stream()
                .filter(shown -> shown.line().distancePx(frame, px, py) <= REACH_PX)
                .map(shown -> shown.path().id())
                .findFirst();
    }

    @Override
    public void offer(Snapping snapping) {
        paths.forEach(shown -> snapping.addLine(shown.line().points()));
    }
}
