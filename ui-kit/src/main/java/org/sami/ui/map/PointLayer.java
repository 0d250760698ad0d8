package org.sami.ui.map;

import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.palette.SemanticColor;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Snapping;

/** Named points, each a cross with its name. */
public final class PointLayer extends MapLayer {
    private static final double ARM = 6;
    private static final double REACH = 10;

    /**
     * A point with a name.
     *
     * @param id stable, unique in the layer
     * @param name the label next to it; empty text for none
     */
    public record MapPoint(String id, String name, GeoPoint at) {}

    private Map<String, MapPoint> points = Map.of();

    public PointLayer(String id, String title) {
        super(id, title);
    }

    /** Shows these points instead of those before. */
    public void show(List<MapPoint> points) {
        Map<String, MapPoint> shown = new LinkedHashMap<>();
        points.forEach(point -> shown.put(point.id(), point));
        this.points = shown;
        changed();
    }

    @Override
    protected void paint(MapPaint paint) {
        points.values().forEach(point -> paint.paint(point.id(), () -> paint(paint, point)));
    }

    private static void paint(MapPaint paint, MapPoint point) {
        double x = paint.frame().px(point.at());
        double y = paint.frame().py(point.at());
        double arm = Painting.px(ARM);
        cross(paint, x, y, arm, 4.5, SemanticColor.MAP_HALO);
        cross(paint, x, y, arm, 2, SemanticColor.MAP_AREA);
        paint.labels().add(x - arm, y - arm, 2 * arm, 2 * arm);
    }

    @Override
    protected void paintNames(MapPaint paint) {
        points.values().stream()
                .filter(point -> !point.name().isEmpty() && paint.frame().isShown(point.at()))
                .forEach(point -> paint.name(point.id(), () -> write(paint, point)));
    }

    private static void write(MapPaint paint, MapPoint point) {
        paint.font(MapPaint.PLAIN);
        Rectangle2D size = paint.plate(point.name(), 0, 0);
        double x = paint.frame().px(point.at());
        double y = paint.frame().py(point.at());
        double apart = Painting.px(ARM) + 3;
        double w = size.getWidth();
        double h = size.getHeight();
        paint.writeName(
                point.name(),
                x + apart,
                y - h / 2,
                x - apart - w,
                y - h / 2,
                x - w / 2,
                y + apart,
                x - w / 2,
                y - apart - h);
    }

    private static void cross(MapPaint paint, double x, double y, double arm, double width, SemanticColor color) {
        paint.g().setStroke(Painting.line(width));
        paint.g().setColor(color.get());
        paint.g().draw(new Line2D.Double(x - arm, y - arm, x + arm, y + arm));
        paint.g().draw(new Line2D.Double(x - arm, y + arm, x + arm, y - arm));
    }

    @Override
    public Optional<GeoBounds> bounds() {
        return GeoBounds.of(points.values().stream().map(MapPoint::at).toList());
    }

    @Override
    public Optional<String> itemAt(MapFrame frame, double px, double py) {
        return points.values().stream()
                .filter(point -> frame.distancePx(point.at(), px, py) <= Painting.px(REACH))
                .min(Comparator.comparingDouble(point -> frame.distancePx(point.at(), px, py)))
                .map(MapPoint::id);
    }

    @Override
    public void offer(Snapping snapping) {
        points.values().forEach(point -> snapping.addCorner(point.at()));
    }
}
