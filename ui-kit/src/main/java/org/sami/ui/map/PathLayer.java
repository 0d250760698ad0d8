package org.sami.ui.map;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Snapping;
import org.sami.ui.map.Sprites.Sprite;

/** Planned paths: thin, the current leg thick, the done part dashed. */
public final class PathLayer extends MapLayer {
    private static final double DOT_PX = 3;
    private static final double REACH_PX = 6;
    private static final double LEAST_LEG_PX = 8; // nearer points have no dots of their own
    private static final BasicStroke THIN = new BasicStroke(1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL);
    private static final BasicStroke THICK = new BasicStroke(4, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL);
    private static final BasicStroke DASHED =
            new BasicStroke(1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL, 10, new float[] {5, 5}, 0);

    private record Shown(PlannedPath path, WorldLine line) {}

    private record Dot(Color color, boolean filled) {}

    private final Sprites<Dot> dots = new Sprites<>();
    private List<Shown> paths = List.of();

    public PathLayer(String id, String title) {
        super(id, title);
    }

    /** Shows these paths instead of those before. */
    public void show(List<PlannedPath> paths) {
        Map<String, Shown> before = new HashMap<>();
        this.paths.forEach(shown -> before.put(shown.path().id(), shown));
        this.paths = paths.stream()
                .map(path -> {
                    Shown known = before.get(path.id());
                    return known != null && known.path().equals(path)
                            ? known
                            : new Shown(path, new WorldLine(path.points()));
                })
                .toList();
        changed();
    }

    @Override
    protected void paint(MapPaint paint) {
        paths.forEach(shown -> paint.paint(shown.path().id(), () -> paint(paint, shown)));
    }

    private void paint(MapPaint paint, Shown shown) {
        WorldLine line = shown.line();
        MapFrame frame = paint.frame();
        Graphics2D g = paint.g();
        int last = line.size() - 1;
        if (last < 0 || !line.isNear(frame)) {
            return;
        }
        int next = shown.path().next();
        Color color = shown.path().mark().color();
        if (paint.imagery()) {
            casing(g, line, frame, next, color);
        }
        g.setColor(color);
        if (next >= 2) {
            g.setStroke(DASHED);
            g.draw(line.path(frame, 0, Math.min(next - 1, last)));
        }
        if (next >= 1 && next <= last) {
            g.setStroke(THICK);
            line.drawLegs(g, frame, next - 1, next);
        }
        g.setStroke(THIN);
        if (next < last) {
            line.drawLegs(g, frame, next, last);
        }
        dots(paint, line, next, color);
    }

    private static void casing(Graphics2D g, WorldLine line, MapFrame frame, int next, Color color) {
        int last = line.size() - 1;
        g.setColor(Casing.of(color));
        g.setStroke(Casing.stroke(THIN));
        g.draw(line.path(frame));
        if (next >= 1 && next <= last) {
            g.setStroke(Casing.stroke(THICK));
            line.drawLegs(g, frame, next - 1, next);
        }
    }

    /** A filled dot for each point to come, a hollow one for each that is done. */
    private void dots(MapPaint paint, WorldLine line, int next, Color color) {
        MapFrame frame = paint.frame();
        Sprite toCome = dot(paint.g(), color, true);
        Sprite done = dot(paint.g(), color, false);
        double lastX = Double.NEGATIVE_INFINITY;
        double lastY = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < line.size(); i++) {
            double x = line.px(frame, i);
            double y = line.py(frame, i);
            if (Math.abs(x - lastX) + Math.abs(y - lastY) >= LEAST_LEG_PX || i == line.size() - 1) {
                (i >= next ? toCome : done).paintAround(paint.g(), x, y);
                lastX = x;
                lastY = y;
            }
        }
    }

    private Sprite dot(Graphics2D g, Color color, boolean filled) {
        double side = 2 * DOT_PX + 3;
        Ellipse2D shape = new Ellipse2D.Double(1.5, 1.5, 2 * DOT_PX, 2 * DOT_PX);
        return dots.get(g, new Dot(color, filled), side, side, own -> {
            own.setColor(color);
            own.setStroke(THIN);
            if (filled) {
                own.fill(shape);
            } else {
                own.draw(shape);
            }
        });
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
