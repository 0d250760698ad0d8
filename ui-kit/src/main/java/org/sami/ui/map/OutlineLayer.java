package org.sami.ui.map;

import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.look.SemanticColor;

/** Outlines of land and constructions, as a base map: polygons filled, lines as they are, points with their names. */
final class OutlineLayer extends MapLayer {
    private final List<List<WorldLine>> polygons;
    private final List<WorldLine> lines;
    private final PointLayer points;
    private final Optional<GeoBounds> bounds;

    OutlineLayer(String file, GeoJson json) {
        super("base-" + file, file);
        polygons = json.polygons().stream()
                .map(rings -> rings.stream().map(WorldLine::new).toList())
                .toList();
        lines = json.lines().stream().map(WorldLine::new).toList();
        points = new PointLayer("points", file);
        List<PointLayer.MapPoint> named = new ArrayList<>();
        json.points().forEach(p -> named.add(new PointLayer.MapPoint("point-" + named.size(), p.name(), p.at())));
        points.show(named);
        List<GeoPoint> all = new ArrayList<>();
        json.lines().forEach(all::addAll);
        json.polygons().forEach(rings -> all.addAll(rings.get(0)));
        json.points().forEach(point -> all.add(point.at()));
        bounds = GeoBounds.of(all);
    }

    @Override
    protected void paintStill(MapPaint paint) {
        paint.g().setStroke(Painting.line(1.5));
        for (List<WorldLine> rings : polygons) {
            Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
            for (WorldLine ring : rings) {
                path.append(ring.path(paint.frame()), false);
                path.closePath();
            }
            paint.g().setColor(SemanticColor.MAP_LAND.get());
            paint.g().fill(path);
            paint.g().setColor(SemanticColor.MAP_OUTLINE.get());
            paint.g().draw(path);
        }
        paint.g().setColor(SemanticColor.MAP_OUTLINE.get());
        lines.forEach(line -> paint.g().draw(line.path(paint.frame())));
        points.paint(paint);
    }

    @Override
    public Optional<GeoBounds> bounds() {
        return bounds;
    }
}
