package org.sami.ui.map.base;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Envelope;

/** One tile of outlines as it is painted. Content outside the tile costs a step for each chunk, not for each point. */
final class OutlineTile {
    private static final double MARGIN_PX = 4; // as wide as a line is
    private static final double LINE_PX = 1.5;
    private static final double LEAST_PX = 0.4;

    private final Outlines outlines;
    private final TileKey key;
    private final BaseStyle style;
    private final Envelope seen;
    private int work;

    OutlineTile(Outlines outlines, TileKey key, BaseStyle style) {
        this.outlines = outlines;
        this.key = key;
        this.style = style;
        double px = WorldInts.stepsPerPx(key.worldPx());
        double beside = MARGIN_PX * Math.max(1, style.lineScale()) * px;
        double left = left();
        double top = top();
        seen = new Envelope(
                left - beside, left + TileKey.PX * px + beside, top - beside, top + TileKey.PX * px + beside);
    }

    private double left() {
        return WorldInts.stepsPerPx(1) * (key.left() - 0.5);
    }

    private double top() {
        return WorldInts.stepsPerPx(1) * (key.top() - 0.5);
    }

    /** The picture; none where there is nothing. Stops early when its thread is interrupted, and where there is too much for one tile. */
    Optional<BufferedImage> paint() {
        List<List<Run>> fills = outlines.fills(seen);
        List<Outlines.Stroke> strokes = outlines.strokes(seen);
        if (fills.isEmpty() && strokes.isEmpty()) {
            return Optional.empty();
        }
        BufferedImage image = new BufferedImage(TileKey.PX, TileKey.PX, BufferedImage.TYPE_INT_ARGB_PRE);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setColor(style.land());
        for (List<Run> rings : fills) {
            if (!isOver()) {
                fill(g, rings);
            }
        }
        g.setColor(style.outline());
        g.setStroke(
                new BasicStroke((float) (LINE_PX * style.lineScale()), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        for (Outlines.Stroke stroke : strokes) {
            if (!isOver()) {
                draw(g, stroke);
            }
        }
        g.dispose();
        return Optional.of(image);
    }

    private boolean isOver() {
        return work > MapFileLimits.TILE_POINTS || Thread.currentThread().isInterrupted();
    }

    /** A chunk wholly above, below, left or right of the tile is replaced by the line between its ends: nothing changes inside the tile. */
    private void fill(Graphics2D g, List<Run> rings) {
        Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
        for (Run ring : rings) {
            path.moveTo(px(ring.x(0)), py(ring.y(0)));
            for (int chunk = 0; chunk < ring.chunks(); chunk++) {
                if (ring.box(chunk).intersects(seen)) {
                    add(path, ring, chunk);
                } else {
                    work++;
                    path.lineTo(px(ring.x(ring.to(chunk))), py(ring.y(ring.to(chunk))));
                }
            }
            path.closePath();
        }
        g.fill(path);
    }

    private void draw(Graphics2D g, Outlines.Stroke stroke) {
        Run run = stroke.run();
        int from = run.from(stroke.chunk());
        Path2D path = new Path2D.Double();
        path.moveTo(px(run.x(from)), py(run.y(from)));
        add(path, run, stroke.chunk());
        g.draw(path);
    }

    private void add(Path2D path, Run run, int chunk) {
        int to = run.to(chunk);
        double lastX = px(run.x(run.from(chunk)));
        double lastY = py(run.y(run.from(chunk)));
        for (int i = run.from(chunk) + 1; i <= to; i++) {
            double x = px(run.x(i));
            double y = py(run.y(i));
            if (i == to || Math.abs(x - lastX) + Math.abs(y - lastY) >= LEAST_PX) {
                path.lineTo(x, y);
                work++;
                lastX = x;
                lastY = y;
            }
        }
    }

    private double px(int x) {
        return (x - left()) / WorldInts.stepsPerPx(key.worldPx());
    }

    private double py(int y) {
        return (y - top()) / WorldInts.stepsPerPx(key.worldPx());
    }
}
