package org.sami.ui.net;

import java.awt.BasicStroke;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Map;
import org.sami.palette.SemanticColor;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;

/** Marks what differs between two versions of a net: a round sign for what is new, a square for what is gone, a diamond for what changed. */
final class ChangePainter {
    private static final double SIGN = 18;
    private static final double LEAST_SIGN_PX = 15;
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
    static void paint(Graphics2D g, double scale, NetScene scene, Map<String, NetChange> changes) {
        double unit = Math.max(1, LEAST_SIGN_PX / SIGN / scale);
        for (Edge edge : scene.edges()) {
            NetChange change = changes.get(edge.id());
            if (change != null) {
                edge(g, edge, change, unit);
            }
        }
        for (Vertex vertex : scene.vertices()) {
            NetChange change = changes.get(vertex.id());
            if (change != null) {
                DrawingBox box = vertex.box().grown(7);
                g.setColor(color(change).get());
                g.setStroke(change == NetChange.REMOVED ? GONE : FRAME);
                g.draw(new RoundRectangle2D.Double(box.x(), box.y(), box.width(), box.height(), 10, 10));
                if (change == NetChange.REMOVED) {
                    g.draw(new Line2D.Double(box.x(), box.maxY(), box.maxX(), box.y()));
                }
                sign(g, box.maxX(), box.y(), change, unit);
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

    private static void edge(Graphics2D g, Edge edge, NetChange change, double unit) {
        Path2D path = new Path2D.Double();
        List<LayoutPoint> points = edge.points();
        path.moveTo(points.get(0).x(), points.get(0).y());
        points.stream().skip(1).forEach(point -> path.lineTo(point.x(), point.y()));
        g.setColor(color(change).withAlpha(150));
        g.setStroke(change == NetChange.REMOVED ? GONE : LINE);
        g.draw(path);
        LayoutPoint from = points.get(points.size() / 2 - 1);
        LayoutPoint to = points.get(points.size() / 2);
        double x = from.x() + 0.25 * (to.x() - from.x());
        double y = from.y() + 0.25 * (to.y() - from.y());
        sign(g, x, y, change, unit);
    }

    private static void sign(Graphics2D g, double x, double y, NetChange change, double unit) {
        double size = SIGN * unit;
        double half = size / 2;
        g.setColor(color(change).get());
        switch (change) {
            case ADDED -> g.fill(new Ellipse2D.Double(x - half, y - half, size, size));
            case REMOVED -> g.fill(new Rectangle2D.Double(x - half, y - half, size, size));
            case CHANGED -> {
                Path2D diamond = new Path2D.Double();
                double far = half * 1.3;
                diamond.moveTo(x, y - far);
                diamond.lineTo(x + far, y);
                diamond.lineTo(x, y + far);
                diamond.lineTo(x - far, y);
                diamond.closePath();
                g.fill(diamond);
            }
        }
        g.setColor(SemanticColor.NET_CANVAS.get());
        g.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 15).deriveFont((float) (15 * unit)));
        double width = g.getFontMetrics().stringWidth(change.sign());
        g.drawString(change.sign(), (float) (x - width / 2), (float) (y + 5.4 * unit));
    }
}
