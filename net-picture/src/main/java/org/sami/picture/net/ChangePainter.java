package org.sami.picture.net;

import java.awt.BasicStroke;
import java.awt.Font;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Map;
import org.sami.palette.MarkShape;
import org.sami.palette.SemanticColor;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;

/** Marks what differs between two versions of a net: a round sign for what is new, a square for what is gone, a diamond for what changed. */
final class ChangePainter {
    private static final double SIGN = 18;
    private static final double LEAST_SIGN_PX = 15;
    private static final Font LETTERS = new Font(Font.SANS_SERIF, Font.BOLD, 15);
    private static final BasicStroke FRAME = new BasicStroke(2.5f);
    private static final BasicStroke LINE = new BasicStroke(4f);
    private static final BasicStroke GONE =
            new BasicStroke(2.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, new float[] {4, 4}, 0);

    private ChangePainter() {}

    /**
     * Paints the marks.
     *
     * @param scale how many pixels a drawing unit has; signs are seen on a small net, too
     */
    static void paint(Pen pen, double scale, NetScene scene, Map<String, NetChange> changes) {
        double unit = Math.max(1, LEAST_SIGN_PX / SIGN / scale);
        for (Edge edge : scene.edges()) {
            NetChange change = changes.get(edge.id());
            if (change != null) {
                edge(pen, edge, change, unit);
            }
        }
        for (Vertex vertex : scene.vertices()) {
            NetChange change = changes.get(vertex.id());
            if (change != null) {
                DrawingBox box = vertex.box().grown(7);
                BasicStroke stroke = change == NetChange.REMOVED ? GONE : FRAME;
                RoundRectangle2D around =
                        new RoundRectangle2D.Double(box.x(), box.y(), box.width(), box.height(), 10, 10);
                pen.draw(around, color(change), stroke);
                if (change == NetChange.REMOVED) {
                    pen.draw(new Line2D.Double(box.x(), box.maxY(), box.maxX(), box.y()), color(change), stroke);
                }
                sign(pen, box.maxX(), box.y(), change, unit);
            }
        }
    }

    private static SemanticColor color(NetChange change) {
        return switch (change) {
            case ADDED -> SemanticColor.OK;
            case REMOVED -> SemanticColor.CRITICAL;
            case CHANGED -> SemanticColor.WARNING;
        };
    }

    private static void edge(Pen pen, Edge edge, NetChange change, double unit) {
        List<LayoutPoint> points = edge.points();
        pen.canvas()
                .draw(
                        Pen.path(points),
                        color(change).withAlpha(150, pen.theme()),
                        change == NetChange.REMOVED ? GONE : LINE);
        LayoutPoint from = points.get(points.size() / 2 - 1);
        LayoutPoint to = points.get(points.size() / 2);
        double x = from.x() + 0.25 * (to.x() - from.x());
        double y = from.y() + 0.25 * (to.y() - from.y());
        sign(pen, x, y, change, unit);
    }

    private static void sign(Pen pen, double x, double y, NetChange change, double unit) {
        double size = SIGN * unit;
        pen.fill(
                switch (change) {
                    case ADDED -> Pen.circle(x, y, size / 2);
                    case REMOVED -> new Rectangle2D.Double(x - size / 2, y - size / 2, size, size);
                    case CHANGED -> MarkShape.DIAMOND.around(x, y, size * 1.13);
                },
                color(change));
        Font font = LETTERS.deriveFont((float) (15 * unit));
        double left = x - NetFonts.width(change.sign(), font) / 2;
        pen.canvas().text(change.sign(), font, pen.color(SemanticColor.NET_CANVAS), left, y + 5.4 * unit);
    }
}
