package org.sami.ui.net;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import org.sami.palette.SemanticColor;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.Vertex;

/** Paints the signs at vertices, over the net. */
final class BadgePainter {
    private static final double PADDING = 5;
    private static final double DOT = 11;
    private static final BasicStroke RIM = new BasicStroke(1.5f);
    private static final BasicStroke DASHED =
            new BasicStroke(2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, new float[] {5, 4}, 0);

    private BadgePainter() {}

    /** Paints in drawing units. */
    static void paint(Graphics2D g, NetScene scene, NetBadges badges) {
        for (Vertex vertex : scene.vertices()) {
            if (badges.unvisited().contains(vertex.id())) {
                around(g, vertex);
            }
            if (badges.breakpoints().contains(vertex.id())) {
                dot(g, vertex);
            }
        }
    }

    private static void around(Graphics2D g, Vertex vertex) {
        g.setColor(SemanticColor.WARNING.get());
        g.setStroke(DASHED);
        if (vertex.kind() == Kind.PLACE) {
            double radius = NetDrawing.PLACE_RADIUS + PADDING;
            g.draw(new Ellipse2D.Double(
                    vertex.centre().x() - radius, vertex.centre().y() - radius, 2 * radius, 2 * radius));
        } else {
            DrawingBox box = vertex.box().grown(PADDING);
            g.draw(new Rectangle2D.Double(box.x(), box.y(), box.width(), box.height()));
        }
    }

    /** At the upper left, where neither tokens nor edges that come from the left are. */
    private static void dot(Graphics2D g, Vertex vertex) {
        double away = vertex.kind() == Kind.PLACE
                ? NetDrawing.PLACE_RADIUS * 0.72
                : vertex.box().width() / 2;
        double down = vertex.kind() == Kind.PLACE ? away : vertex.box().height() / 2;
        Ellipse2D dot = new Ellipse2D.Double(
                vertex.centre().x() - away - DOT / 2, vertex.centre().y() - down - DOT / 2, DOT, DOT);
        g.setColor(SemanticColor.CRITICAL_FILL.get());
        g.fill(dot);
        g.setColor(SemanticColor.NET_CANVAS.get());
        g.setStroke(RIM);
        g.draw(dot);
    }
}
