package org.sami.ui.map;

import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.palette.SemanticColor;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoMeasure;
import org.sami.ui.geo.GeoShape;
import org.sami.ui.geo.GeoSketch;
import org.sami.ui.geo.MapFrame;

/** Paints a sketch with its handles, the line to the pointer, and lengths and area. */
final class SketchPainter {
    private static final double HANDLE_PX = 6;
    private static final double MIDDLE_PX = 4;
    private static final double LEAST_LINE_PX = 44; // a shorter line has no handle in its middle

    private final GeoSketch sketch;
    private final boolean measuring;
    private Optional<GeoPoint> pointer = Optional.empty();

    SketchPainter(GeoSketch sketch, boolean measuring) {
        this.sketch = sketch;
        this.measuring = measuring;
    }

    void pointTo(MapPointer to) {
        pointer = Optional.of(to.at());
    }

    /** Where the pointer was last; none where it was not on the map. */
    Optional<GeoPoint> pointedTo() {
        return pointer;
    }

    /** The points of the line: an area's first one comes again as its last. */
    List<GeoPoint> ring() {
        if (sketch.shape() == GeoShape.POINT || sketch.shape() == GeoShape.POINTS) {
            return List.of();
        }
        List<GeoPoint> ring = new ArrayList<>(sketch.points());
        if (sketch.shape() == GeoShape.AREA && ring.size() > 2) {
            ring.add(ring.get(0));
        }
        return ring;
    }

    static GeoPoint middle(MapFrame frame, GeoPoint a, GeoPoint b) {
        return frame.point((frame.px(a) + frame.px(b)) / 2, (frame.py(a) + frame.py(b)) / 2);
    }

    /** Whether there is room for a handle in the middle of the line that ends at that index of {@link #ring}. */
    boolean hasMiddle(MapFrame frame, int index) {
        GeoPoint a = ring().get(index - 1);
        return frame.distancePx(a, frame.px(ring().get(index)), frame.py(ring().get(index)))
                >= Painting.px(LEAST_LINE_PX);
    }

    void paint(MapPaint paint) {
        Graphics2D g = paint.g();
        Path2D path = path(paint.frame());
        if (sketch.shape() == GeoShape.AREA) {
            g.setColor(SemanticColor.MAP_HIGHLIGHT.withAlpha(40));
            g.fill(path);
        }
        stroke(g, path);
        toPointer(paint);
        handles(paint);
    }

    /** Writes lengths and area. */
    void paintNames(MapPaint paint) {
        paint.font(MapPaint.PLAIN);
        if (measuring) {
            legs(paint);
        }
        total(paint);
    }

    private Path2D path(MapFrame frame) {
        Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
        List<List<GeoPoint>> rings = new ArrayList<>(sketch.holes());
        rings.add(ring());
        for (List<GeoPoint> ring : rings) {
            for (int i = 0; i < ring.size(); i++) {
                if (i == 0) {
                    path.moveTo(frame.px(ring.get(i)), frame.py(ring.get(i)));
                } else {
                    path.lineTo(frame.px(ring.get(i)), frame.py(ring.get(i)));
                }
            }
        }
        return path;
    }

    private static void stroke(Graphics2D g, Path2D path) {
        g.setColor(SemanticColor.MAP_HALO.withAlpha(180));
        g.setStroke(Painting.line(5));
        g.draw(path);
        g.setColor(SemanticColor.MAP_HIGHLIGHT.get());
        g.setStroke(Painting.line(2.5));
        g.draw(path);
    }

    /** The line that a click would make. */
    private void toPointer(MapPaint paint) {
        List<GeoPoint> points = sketch.points();
        if (pointer.isEmpty() || points.isEmpty() || ring().isEmpty()) {
            return;
        }
        MapFrame frame = paint.frame();
        Path2D line = new Path2D.Double();
        GeoPoint last = points.get(points.size() - 1);
        line.moveTo(frame.px(last), frame.py(last));
        line.lineTo(frame.px(pointer.get()), frame.py(pointer.get()));
        if (sketch.shape() == GeoShape.AREA && points.size() > 1) {
            line.lineTo(frame.px(points.get(0)), frame.py(points.get(0)));
        }
        paint.g().setColor(SemanticColor.MAP_HIGHLIGHT.get());
        paint.g().setStroke(Painting.dashed(1.5, 4, 4));
        paint.g().draw(line);
    }

    private void handles(MapPaint paint) {
        MapFrame frame = paint.frame();
        List<GeoPoint> ring = ring();
        for (int i = 1; i < ring.size(); i++) {
            if (hasMiddle(frame, i)) {
                handle(paint, middle(frame, ring.get(i - 1), ring.get(i)), MIDDLE_PX, false);
            }
        }
        for (int i = 0; i < sketch.points().size(); i++) {
            handle(paint, sketch.points().get(i), HANDLE_PX, sketch.selected().orElse(-1) == i);
        }
    }

    private static void handle(MapPaint paint, GeoPoint at, double logical, boolean filled) {
        double r = Painting.px(logical);
        Ellipse2D dot =
                new Ellipse2D.Double(paint.frame().px(at) - r, paint.frame().py(at) - r, 2 * r, 2 * r);
        paint.g().setColor(filled ? SemanticColor.MAP_HIGHLIGHT.get() : SemanticColor.MAP_HALO.get());
        paint.g().fill(dot);
        paint.g().setColor(SemanticColor.MAP_HIGHLIGHT.get());
        paint.g().setStroke(Painting.line(2));
        paint.g().draw(dot);
        paint.labels().add(dot.getX(), dot.getY(), dot.getWidth(), dot.getHeight());
    }

    private void legs(MapPaint paint) {
        List<GeoPoint> ring = ring();
        for (int i = 1; i < ring.size(); i++) {
            if (hasMiddle(paint.frame(), i)) {
                GeoPoint middle = middle(paint.frame(), ring.get(i - 1), ring.get(i));
                String text = GeoMeasure.length(GeoMeasure.metres(ring.get(i - 1), ring.get(i)));
                write(paint, text, middle, 0);
            }
        }
    }

    private void total(MapPaint paint) {
        List<GeoPoint> points = sketch.points();
        if (points.isEmpty()) {
            return;
        }
        GeoPoint last = points.get(points.size() - 1);
        if (sketch.shape() == GeoShape.AREA && points.size() > 2) {
            write(paint, GeoMeasure.area(GeoMeasure.squareMetres(points)), last, 1);
        } else if (sketch.shape() == GeoShape.PATH && points.size() > 1) {
            write(paint, GeoMeasure.length(GeoMeasure.length(points)) + " in all", last, 1);
        }
    }

    private static void write(MapPaint paint, String text, GeoPoint at, int lines) {
        double x = paint.frame().px(at) + Painting.px(10);
        double y = paint.frame().py(at) + Painting.px(6);
        Rectangle2D plate = paint.plate(text, x, y);
        Rectangle2D room = paint.plate(text, x, y + lines * plate.getHeight() / 4);
        paint.labels().addText(room.getX(), room.getY(), room.getWidth(), room.getHeight());
        paint.write(text, room);
    }
}
