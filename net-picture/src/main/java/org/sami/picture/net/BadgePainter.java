package org.sami.picture.net;

import java.awt.BasicStroke;
import java.awt.Font;
import org.sami.palette.SemanticColor;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.drawing.TextStyle;

/** Paints the signs at vertices, over the net. */
final class BadgePainter {
    private static final double PADDING = 5;
    private static final double DOT = 11;
    private static final double LABEL_MARGIN = 3;
    private static final double DESCENT = 0.1;
    private static final BasicStroke RIM = new BasicStroke(1.5f);
    private static final BasicStroke DASHED =
            new BasicStroke(2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, new float[] {5, 4}, 0);

    private BadgePainter() {}

    /** Paints them. */
    static void paint(Pen pen, NetScene scene, NetBadges badges, NetSight sight) {
        for (Vertex vertex : scene.vertices()) {
            if (badges.unvisited().contains(vertex.id())) {
                around(pen, vertex);
            }
            if (badges.breakpoints().contains(vertex.id())) {
                dot(pen, vertex);
            }
            String bound = badges.bounds().get(vertex.id());
            if (bound != null) {
                label(pen, vertex, bound, Math.max(1, sight.unit()));
            }
        }
    }

    /** Above the place, where neither its name nor those of transitions next to it are; as large as names are, from afar too. */
    private static void label(Pen pen, Vertex vertex, String words, double unit) {
        float letters = (float) (TextStyle.EVENT.size() * unit);
        Font font = NetFonts.of(TextStyle.EVENT).deriveFont(letters);
        double margin = LABEL_MARGIN * unit;
        double width = NetFonts.width(words, font) + 2 * margin;
        double left = vertex.centre().x() - width / 2;
        double bottom = vertex.centre().y() - NetDrawing.PLACE_RADIUS - LABEL_MARGIN;
        DrawingBox box = new DrawingBox(left, bottom - letters - 2 * margin, width, letters + 2 * margin);
        pen.fillAndDraw(Pen.rectangle(box), SemanticColor.NET_CANVAS, SemanticColor.ACCENT, RIM);
        pen.canvas()
                .text(words, font, pen.color(SemanticColor.TEXT), left + margin, bottom - margin - letters * DESCENT);
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
