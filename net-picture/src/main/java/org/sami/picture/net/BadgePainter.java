package org.sami.picture.net;

import java.awt.BasicStroke;
import org.sami.palette.SemanticColor;
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

    /** Paints them. */
    static void paint(Pen pen, NetScene scene, NetBadges badges) {
        for (Vertex vertex : scene.vertices()) {
            if (badges.unvisited().contains(vertex.id())) {
                around(pen, vertex);
            }
            if (badges.breakpoints().contains(vertex.id())) {
                dot(pen, vertex);
            }
        }
    }

    private static void around(Pen pen, Vertex vertex) {
        pen.draw(
                vertex.kind() == Kind.PLACE
                        ? Pen.circle(vertex.centre().x(), vertex.centre().y(), NetDrawing.PLACE_RADIUS + PADDING)
                        : Pen.rectangle(vertex.box().grown(PADDING)),
                SemanticColor.WARNING,
                DASHED);
    }

    /** At the upper left, where neither tokens nor edges that come from the left are. */
    private static void dot(Pen pen, Vertex vertex) {
        double away = vertex.kind() == Kind.PLACE
                ? NetDrawing.PLACE_RADIUS * 0.72
                : vertex.box().width() / 2;
        double down = vertex.kind() == Kind.PLACE ? away : vertex.box().height() / 2;
        pen.fillAndDraw(
                Pen.circle(vertex.centre().x() - away, vertex.centre().y() - down, DOT / 2),
                SemanticColor.CRITICAL_FILL,
                SemanticColor.NET_CANVAS,
                RIM);
    }
}
