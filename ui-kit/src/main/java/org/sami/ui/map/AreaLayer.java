package org.sami.ui.map;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Paint;
import java.awt.RenderingHints;
import java.awt.TexturePaint;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.palette.SemanticColor;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Mercator;
import org.sami.ui.geo.Snapping;

/** Areas: filled where something is to be done, hatched where none may go, dashed where none may leave. The latter two are never dimmed. */
public final class AreaLayer extends MapLayer {
    private static final int HATCH_PX = 9;
    private static final int HATCH_ON_IMAGERY_PX = 14;
    private static final double NAME_PX = 4;
    private static final BasicStroke RIM = new BasicStroke(2);
    private static final BasicStroke FENCE = new BasicStroke(2.5f);
    private static final BasicStroke DASHED =
            new BasicStroke(2.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, new float[] {10, 6}, 0);

    private record Shown(ShownArea area, List<WorldLine> rings) {
        Path2D path(MapFrame frame) {
            Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
            for (WorldLine ring : rings) {
                path.append(ring.path(frame), false);
                path.closePath();
            }
            return path;
        }
    }

    private List<Shown> areas = List.of();

    public AreaLayer(String id, String title) {
        super(id, title);
    }

    /** Shows these areas instead of those before. */
    public void show(List<ShownArea> areas) {
        if (areas.equals(this.areas.stream().map(Shown::area).toList())) {
            return;
        }
        this.areas = areas.stream()
                .map(area -> {
                    List<WorldLine> rings = new ArrayList<>();
                    rings.add(new WorldLine(area.area().outline()));
                    area.area().holes().stream()
                            .filter(hole -> !hole.isEmpty())
                            .forEach(hole -> rings.add(new WorldLine(hole)));
                    return new Shown(area, rings);
                })
                .toList();
        stillChanged();
    }

    @Override
    protected void paintStill(MapPaint paint) {
        areas.forEach(shown -> dimmed(paint, shown.area(), () -> paint(paint, shown)));
    }

    /** Where none may go, and what none may leave, is seen in full whatever is spoken of: who draws or chooses keeps to it. */
    private static void dimmed(MapPaint paint, ShownArea area, Runnable painting) {
        if (area.kind() == ShownArea.Kind.WORK) {
            paint.paint(area.id(), painting);
        } else {
            painting.run();
        }
    }

    private static void paint(MapPaint paint, Shown shown) {
        Graphics2D g = paint.g();
        Path2D path = shown.path(paint.frame());
        switch (shown.area().kind()) {
            case WORK -> fill(paint, path, SemanticColor.MAP_AREA.withAlpha(40), SemanticColor.MAP_AREA.get());
            case NO_GO -> fill(paint, path, hatch(paint.imagery()), SemanticColor.MAP_NO_GO.get());
            case FENCE -> {
                Casing.draw(paint, path, SemanticColor.MAP_FENCE.get(), FENCE);
                g.setStroke(DASHED);
                g.draw(path);
            }
        }
    }

    @Override
    protected void paintNames(MapPaint paint) {
        areas.stream().filter(shown -> !shown.area().name().isEmpty()).forEach(shown -> {
            if (shown.area().kind() == ShownArea.Kind.WORK) {
                paint.name(shown.area().id(), () -> write(paint, shown));
            } else {
                write(paint, shown);
            }
        });
    }

    /** In a corner of what is seen of the area, or just outside of one that is small. */
    private static void write(MapPaint paint, Shown shown) {
        MapFrame frame = paint.frame();
        Rectangle2D seen = shown.rings()
                .get(0)
                .bounds()
                .map(box -> new Rectangle2D.Double(
                                frame.px(Mercator.x(box.westDeg())),
                                frame.py(Mercator.y(box.northDeg())),
                                (Mercator.x(box.eastDeg()) - Mercator.x(box.westDeg())) * frame.worldPx(),
                                (Mercator.y(box.southDeg()) - Mercator.y(box.northDeg())) * frame.worldPx())
                        .createIntersection(new Rectangle2D.Double(0, 0, frame.width(), frame.height())))
                .orElse(new Rectangle2D.Double());
        if (seen.isEmpty()) {
            return;
        }
        paint.font(MapPaint.PLAIN);
        Rectangle2D size = paint.plate(shown.area().name(), 0, 0);
        double left = seen.getMinX() + NAME_PX;
        double right = seen.getMaxX() - NAME_PX - size.getWidth();
        double top = seen.getMinY() + NAME_PX;
        double bottom = seen.getMaxY() - NAME_PX - size.getHeight();
        double above = seen.getMinY() - NAME_PX - size.getHeight();
        double below = seen.getMaxY() + NAME_PX;
        if (right < left || bottom < top) {
            paint.writeName(shown.area().name(), left, above, left, below, right, above, right, below);
        } else {
            paint.writeName(
                    shown.area().name(), left, top, right, top, left, bottom, right, bottom, left, above, left, below);
        }
    }

    private static void fill(MapPaint paint, Path2D path, Paint inside, Color rim) {
        paint.g().setPaint(inside);
        paint.g().fill(path);
        Casing.draw(paint, path, rim, RIM);
        paint.g().draw(path);
    }

    /** Lines from the lower left to the upper right; on imagery farther apart, each with its casing. */
    private static TexturePaint hatch(boolean imagery) {
        int side = imagery ? HATCH_ON_IMAGERY_PX : HATCH_PX;
        BufferedImage tile = new BufferedImage(side, side, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = tile.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        if (imagery) {
            g.setColor(Casing.of(SemanticColor.MAP_NO_GO.get()));
            g.setStroke(new BasicStroke(4));
            lines(g, side);
            g.setColor(SemanticColor.MAP_NO_GO.get());
            g.setStroke(new BasicStroke(2));
        } else {
            g.setColor(SemanticColor.MAP_NO_GO.withAlpha(150));
            g.setStroke(new BasicStroke(1.6f));
        }
        lines(g, side);
        g.dispose();
        return new TexturePaint(tile, new Rectangle2D.Double(0, 0, side, side));
    }

    private static void lines(Graphics2D g, int side) {
        g.drawLine(-side, side, side, -side);
        g.drawLine(-side, 2 * side, 2 * side, -side);
        g.drawLine(0, 2 * side, 2 * side, 0);
    }

    @Override
    public Optional<GeoBounds> bounds() {
        return areas.stream()
                .flatMap(shown -> shown.rings().get(0).bounds().stream())
                .reduce(GeoBounds::with);
    }

    @Override
    public Optional<String> itemAt(MapFrame frame, double px, double py) {
        return areas.stream()
                .filter(shown -> shown.area().kind() != ShownArea.Kind.FENCE)
                .filter(shown -> shown.path(frame).contains(px, py))
                .map(shown -> shown.area().id())
                .findFirst();
    }

    @Override
    public void offer(Snapping snapping) {
        areas.forEach(shown -> shown.rings().forEach(ring -> snapping.addOutline(ring.points())));
    }
}
