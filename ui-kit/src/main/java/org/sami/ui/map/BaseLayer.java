package org.sami.ui.map;

import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.palette.SemanticColor;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.map.base.BaseSource;
import org.sami.ui.map.base.NamedPoint;

/** A base map as a layer of a map view: images of tiles, and the names of its named points next to them. */
final class BaseLayer extends MapLayer {
    private static final int MOST_NAMES = 150; // in sight; more would hide the map
    private static final double DOT = 3;

    private final Path file;
    private final BaseSource source;
    private final BaseTiles tiles;

    /**
     * The layer of a base map.
     *
     * @param owns whether it closes the base map in the end; else another map view does
     * @param looked is run when tiles are asked for or have come
     * @param problems receives, in one line, what is wrong with a tile
     */
    BaseLayer(String id, Path file, BaseSource source, boolean owns, Runnable looked, Consumer<String> problems) {
        super(id, source.name());
        this.file = file;
        this.source = source;
        tiles = new BaseTiles(
                source,
                owns,
                () -> {
                    stillChanged();
                    looked.run();
                },
                looked,
                problems);
    }

    Path file() {
        return file;
    }

    BaseSource source() {
        return source;
    }

    boolean isReading() {
        return isVisible() && tiles.isReading();
    }

    /** Shows or hides it; what is hidden keeps no pictures. */
    void setOn(boolean on) {
        setVisible(on);
        if (!on) {
            tiles.clear();
        }
    }

    @Override
    protected void paintStill(MapPaint paint) {
        tiles.paint(paint.g(), paint.frame());
    }

    @Override
    protected void paint(MapPaint paint) {
        double dot = Painting.px(DOT);
        for (NamedPoint point : names(paint)) {
            double x = paint.frame().px(point.at());
            double y = paint.frame().py(point.at());
            paint.g().setColor(SemanticColor.MAP_HALO.get());
            paint.g().fill(new Ellipse2D.Double(x - dot - 1.5, y - dot - 1.5, 2 * dot + 3, 2 * dot + 3));
            paint.g().setColor(SemanticColor.MAP_OUTLINE.get());
            paint.g().fill(new Ellipse2D.Double(x - dot, y - dot, 2 * dot, 2 * dot));
            paint.labels().add(x - dot, y - dot, 2 * dot, 2 * dot);
        }
    }

    private List<NamedPoint> names(MapPaint paint) {
        return source.names(paint.frame(), MOST_NAMES);
    }

    @Override
    protected void paintNames(MapPaint paint) {
        for (NamedPoint point : names(paint)) {
            if (!point.name().isEmpty()) {
                paint.font(MapPaint.PLAIN);
                Rectangle2D size = paint.plate(point.name(), 0, 0);
                double x = paint.frame().px(point.at());
                double y = paint.frame().py(point.at()) - size.getHeight() / 2;
                double apart = Painting.px(DOT) + 3;
                paint.writeName(point.name(), x + apart, y, x - apart - size.getWidth(), y);
            }
        }
    }

    /** The box of the base map, which is not what people want to see at first: it may be half the world. */
    Optional<GeoBounds> extent() {
        return source.bounds();
    }

    void close() {
        tiles.close();
    }
}
