package org.sami.crw.report.picture;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.util.Comparator;
import java.util.List;
import org.sami.crw.report.MapArea;
import org.sami.crw.report.MapNames;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.RunReport;

/** The areas of the plan on the map, distinguished by rim and hatching, not by colour alone. */
final class AreaDrawing {
    private static final int HATCH = 9;

    private AreaDrawing() {}

    static void draw(Graphics2D g, RunReport report, Rectangle frame, MapScale scale) {
        Shape before = g.getClip();
        g.clip(frame);
        List<MapArea> areas = MapNames.areas(report).stream()
                .sorted(Comparator.comparing(MapArea::kind)) // what covers comes last
                .toList();
        for (MapArea area : areas) {
            Path2D shape = new Path2D.Double(Path2D.WIND_EVEN_ODD);
            ring(shape, area.outline(), scale);
            area.holes().forEach(hole -> ring(shape, hole, scale));
            area(g, area.kind(), shape);
        }
        g.setClip(before);
    }

    private static void ring(Path2D shape, List<MapPoint> points, MapScale scale) {
        for (int i = 0; i < points.size(); i++) {
            Point2D at = scale.at(points.get(i).eastM(), points.get(i).northM());
            if (i == 0) {
                shape.moveTo(at.getX(), at.getY());
            } else {
                shape.lineTo(at.getX(), at.getY());
            }
        }
        shape.closePath();
    }

    /** One area; the legend shows the same. */
    static void area(Graphics2D g, MapArea.Kind kind, Shape shape) {
        Color color = MapColors.area(kind);
        if (kind == MapArea.Kind.EXPLORED) {
            g.setColor(new Color(color.getRed(), color.getGreen(), color.getBlue(), 60));
            g.fill(shape);
        } else if (kind == MapArea.Kind.UNCOVERED) {
            g.setColor(new Color(color.getRed(), color.getGreen(), color.getBlue(), 70));
            g.fill(shape);
            hatch(g, shape, color, false);
        } else if (kind == MapArea.Kind.AVOIDED) {
            g.setColor(MapColors.PAPER);
            g.fill(shape);
            hatch(g, shape, color, true);
        }
        g.setColor(color);
        g.setStroke(
                switch (kind) {
                    case EXPLORED -> MapColors.dashed(1.6f);
                    case UNCOVERED -> MapColors.dashed(0.8f);
                    case AVOIDED -> MapColors.dashed(2);
                    case LIMIT -> MapColors.dashed(1.8f, 14, 4, 3, 4);
                    case OTHER -> MapColors.dashed(1.6f, 3, 4);
                });
        g.draw(shape);
    }

    private static void hatch(Graphics2D g, Shape shape, Color color, boolean crossed) {
        Graphics2D inside = (Graphics2D) g.create();
        inside.clip(shape);
        inside.setColor(color);
        inside.setStroke(MapColors.dashed(1));
        Rectangle box = inside.getClipBounds();
        int size = box.width + box.height;
        for (int d = -(size + Math.floorMod(box.x + box.y, HATCH)); d <= size; d += HATCH) {
            inside.draw(new Line2D.Double(box.x + d, box.y, box.x + d + size, box.y + size));
            if (crossed) {
                inside.draw(new Line2D.Double(box.x + d + size, box.y, box.x + d, box.y + size));
            }
        }
        inside.dispose();
    }
}
