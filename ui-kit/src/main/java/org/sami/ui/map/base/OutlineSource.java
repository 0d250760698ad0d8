package org.sami.ui.map.base;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.index.strtree.STRtree;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Mercator;

/** Outlines of a GeoJSON file as a base map: simplified for each scale, painted in tiles. Immutable. */
public final class OutlineSource implements BaseSource {
    private static final double FINEST_PX = Math.scalb((double) TileKey.PX, 22);
    private static final double COARSER = 8; // from one set of outlines to the next
    private static final double COARSEST_PX = TileKey.PX;
    private static final double MAX_POINTS_RATIO =
            0.8; // a level that saves less than a fifth of the points is not kept in addition to the finer one

    /** Outlines, and the scale up to which they show all that can be seen. */
    private record Level(double worldPx, Outlines outlines) {}

    private final String name;
    private final Optional<String> restriction;
    private final List<Level> levels; // the finest first
    private final STRtree names = new STRtree();
    private final boolean hasNames;
    private final Optional<GeoBounds> bounds;

    private OutlineSource(Path file, OutlineCollector json, List<Level> levels) {
        this.name = MapFileLimits.cut(file.getFileName().toString(), MapFileLimits.NAME_LETTERS);
        this.restriction = json.restriction();
        this.levels = levels;
        json.names().forEach(point -> names.insert(new Envelope(at(point)), point));
        names.build();
        hasNames = !json.names().isEmpty();
        Envelope all = levels.get(0).outlines().box().orElseGet(Envelope::new);
        json.names().forEach(point -> all.expandToInclude(at(point)));
        bounds = all.isNull() ? Optional.empty() : Optional.of(bounds(all));
    }

    private static Coordinate at(NamedPoint point) {
        return new Coordinate(
                WorldInts.of(Mercator.x(point.at().lonDeg())),
                WorldInts.of(Mercator.y(point.at().latDeg())));
    }

    private static GeoBounds bounds(Envelope box) {
        return GeoBounds.of(List.of(
                        Mercator.point(WorldInts.unit((int) box.getMinX()), WorldInts.unit((int) box.getMinY())),
                        Mercator.point(WorldInts.unit((int) box.getMaxX()), WorldInts.unit((int) box.getMaxY()))))
                .orElseThrow();
    }

    /**
     * Reads a file, or a pipe, and prepares its outlines for all scales; ends when its thread is interrupted.
     *
     * @throws IOException with the file's name, the place in it and what is wrong
     */
    public static OutlineSource read(Path file, MapFileLimits budget) throws IOException {
        OutlineCollector json = GeoJson.read(file, budget);
        List<Level> levels = new ArrayList<>();
        try {
            Outlines outlines = json.outlines();
            levels.add(new Level(Double.POSITIVE_INFINITY, outlines));
            for (double px = FINEST_PX / COARSER; px >= COARSEST_PX; px /= COARSER) {
                Outlines simpler = outlines.simplified(px);
                if (simpler.points() < MAX_POINTS_RATIO * outlines.points()
                        || simpler.count() < MAX_POINTS_RATIO * outlines.count()) {
                    levels.add(new Level(px, simpler));
                    outlines = simpler;
                }
            }
        } catch (InterruptedException left) {
            throw new IOException(file + " was left", left);
        }
        return new OutlineSource(file, json, List.copyOf(levels));
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public String attribution() {
        return "";
    }

    @Override
    public Optional<GeoBounds> bounds() {
        return bounds;
    }

    @Override
    public boolean isImagery() {
        return false;
    }

    @Override
    public Optional<String> restriction() {
        return restriction;
    }

    @Override
    public double tileScale(double worldPx) {
        return worldPx;
    }

    @Override
    public OptionalDouble coarser(double tileScale) {
        return OptionalDouble.empty();
    }

    @Override
    public Optional<BufferedImage> tile(TileKey key, BaseStyle style) {
        Outlines fitting = levels.get(0).outlines();
        for (Level level : levels) {
            if (level.worldPx() >= key.worldPx()) {
                fitting = level.outlines();
            }
        }
        return new OutlineTile(fitting, key, style).paint();
    }

    @Override
    public List<NamedPoint> names(MapFrame frame, int most) {
        if (!hasNames) {
            return List.of();
        }
        Envelope box = new Envelope();
        box.expandToInclude(at(new NamedPoint("", frame.point(0, 0))));
        box.expandToInclude(at(new NamedPoint("", frame.point(frame.width(), frame.height()))));
        List<NamedPoint> found = new ArrayList<>();
        for (Object point : names.query(box)) {
            found.add((NamedPoint) point);
        }
        return found.size() > most ? List.of() : found;
    }

    @Override
    public void close() {
        // nothing is open
    }
}
