package org.sami.ui.net;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.sami.palette.IdentityMarks;
import org.sami.palette.SemanticColor;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.Label;
import org.sami.spn.drawing.NetDrawing.NoteBox;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.drawing.TextBlock;
import org.sami.spn.drawing.TextStyle;
import org.sami.spn.model.LayoutPoint;

/** Paints a scene in drawing units: places as circles, transitions as bars (thesis, Figure 3.1), tokens as chips. */
final class NetPainter {
    private static final double ARROW = 9;
    private static final double ARROW_ANGLE = 0.42;
    private static final double RING = 5; // between the two circles of a place with a sub-mission
    private static final double ASCENT = 0.98; // of a letter's size, from the top of its line to its base line
    private static final double GLOW = 7;
    private static final double LEAST_ZOOM_OF_TEXT = 0.6; // smaller than that nobody reads it

    private final TokenPainter tokens;

    NetPainter(IdentityMarks marks) {
        tokens = new TokenPainter(marks);
    }

    /**
     * Paints what lies in the clip.
     *
     * @param g in drawing units
     * @param scale how many pixels a drawing unit has
     * @param own how many it has at the net's own size, where its letters are as large as those of the window
     */
    void paint(Graphics2D g, double scale, double own, NetScene scene, NetMarking marking, NetLight light) {
        hint(g);
        DrawingBox clip = clip(g, scene);
        boolean words = scale >= LEAST_ZOOM_OF_TEXT * own;
        NetStrokes strokes = NetStrokes.at(scale / own);
        FramePainter frames = new FramePainter(scene.frames());
        frames.paint(g, light.selected(), words ? 1 : own / scale);
        for (NoteBox note : scene.notes()) {
            if (clip.intersects(note.box())) {
                NotePainter.paint(g, note, light.selected().contains(NetScene.idOf(note.index())), words);
            }
        }
        List<Edge> edges = scene.edges().stream()
                .filter(edge -> clip.intersects(box(edge)))
                .toList();
        for (Edge edge : edges) {
            edge(g, edge, light, strokes);
        }
        if (words) { // a line that crosses a text must not show through it
            for (Label label : scene.labels()) {
                if (clip.intersects(label.box())) {
                    g.setColor(frames.below(label.box()));
                    g.fill(rectangle(label.box().grown(1)));
                }
            }
        }
        for (Edge edge : edges) {
            arrow(g, edge, light);
        }
        scene.silhouettes().forEach(vertex -> silhouette(g, vertex));
        for (Vertex vertex : scene.vertices()) {
            if (clip.intersects(vertex.box().grown(GLOW))) {
                vertex(g, vertex, marking, light, strokes);
            }
        }
        if (words) {
            for (Label label : scene.labels()) {
                if (clip.intersects(label.box())) {
                    write(g, label);
                }
            }
        } else {
            FarNames.paint(g, own / scale, scene, marking, light, clip, frames);
            for (Label label : scene.labels()) { // what is missing is seen from afar, too
                if (isMissing(label) && clip.intersects(label.box())) {
                    missing(g, label.box());
                }
            }
        }
        ChangePainter.paint(g, scale, scene, light.changes());
    }

    private static void hint(Graphics2D g) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    }

    private static DrawingBox clip(Graphics2D g, NetScene scene) {
        Rectangle2D clip = g.getClip() == null ? null : g.getClip().getBounds2D();
        return clip == null
                ? scene.bounds().grown(GLOW)
                : new DrawingBox(clip.getX(), clip.getY(), clip.getWidth(), clip.getHeight());
    }

    /** The box around an edge with its arrow. */
    private static DrawingBox box(Edge edge) {
        double left = Double.POSITIVE_INFINITY;
        double top = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double bottom = Double.NEGATIVE_INFINITY;
        for (LayoutPoint point : edge.points()) {
            left = Math.min(left, point.x());
            top = Math.min(top, point.y());
            right = Math.max(right, point.x());
            bottom = Math.max(bottom, point.y());
        }
        return new DrawingBox(left, top, right - left, bottom - top).grown(ARROW);
    }

    private static Rectangle2D rectangle(DrawingBox box) {
        return new Rectangle2D.Double(box.x(), box.y(), box.width(), box.height());
    }

    private static Color color(Edge edge, NetLight light) {
        if (light.selected().contains(edge.id())) {
            return SemanticColor.ACCENT.get();
        }
        if (light.highlighted().contains(edge.id())) {
            return SemanticColor.CRITICAL.get();
        }
        return (edge.recovery() ? SemanticColor.NET_RECOVERY : SemanticColor.NET_EDGE).get();
    }

    private static void edge(Graphics2D g, Edge edge, NetLight light, NetStrokes strokes) {
        boolean lit =
                light.selected().contains(edge.id()) || light.highlighted().contains(edge.id());
        Path2D path = new Path2D.Double();
        List<LayoutPoint> points = edge.points();
        path.moveTo(points.get(0).x(), points.get(0).y());
        points.stream().skip(1).forEach(point -> path.lineTo(point.x(), point.y()));
        g.setColor(color(edge, light));
        g.setStroke(lit ? strokes.thick() : edge.unconditional() ? strokes.dashed() : strokes.thin());
        g.draw(path);
    }

    private static void arrow(Graphics2D g, Edge edge, NetLight light) {
        List<LayoutPoint> points = edge.points();
        LayoutPoint tip = points.get(points.size() - 1);
        LayoutPoint before = points.get(points.size() - 2);
        double angle = Math.atan2(tip.y() - before.y(), tip.x() - before.x());
        Path2D head = new Path2D.Double();
        head.moveTo(tip.x(), tip.y());
        for (double aside : new double[] {ARROW_ANGLE, -ARROW_ANGLE}) {
            head.lineTo(tip.x() - ARROW * Math.cos(angle + aside), tip.y() - ARROW * Math.sin(angle + aside));
        }
        head.closePath();
        g.setColor(color(edge, light));
        g.fill(head);
    }

    private static void silhouette(Graphics2D g, Vertex vertex) {
        g.setColor(SemanticColor.NET_RECOVERY.get());
        if (vertex.kind() == Kind.PLACE) {
            g.fill(circle(vertex, NetDrawing.PLACE_RADIUS - 1));
        } else {
            g.fill(rectangle(vertex.box()));
        }
    }

    private static Ellipse2D circle(Vertex vertex, double radius) {
        return new Ellipse2D.Double(
                vertex.centre().x() - radius, vertex.centre().y() - radius, 2 * radius, 2 * radius);
    }

    private void vertex(Graphics2D g, Vertex vertex, NetMarking marking, NetLight light, NetStrokes strokes) {
        around(g, vertex, light, strokes);
        if (vertex.kind() == Kind.TRANSITION) {
            transition(g, vertex, light.firing().applyAsDouble(vertex.id()));
            disabled(g, vertex, NetDrawing.PLACE_RADIUS / 2, strokes);
        } else {
            place(g, vertex, marking.isActive(vertex.id()), strokes);
            tokens.paint(g, vertex, marking);
            disabled(g, vertex, NetDrawing.PLACE_RADIUS * 0.7, strokes);
        }
    }

    /** A stroke through an element that is left out while the plan is tried; "disabled" is written next to it. */
    private static void disabled(Graphics2D g, Vertex vertex, double reach, NetStrokes strokes) {
        if (vertex.disabled()) {
            double x = vertex.centre().x();
            double y = vertex.centre().y();
            g.setColor(SemanticColor.WARNING.get());
            g.setStroke(strokes.thick());
            g.draw(new Line2D.Double(x - reach, y + reach, x + reach, y - reach));
        }
    }

    /** What is selected or spoken of has a band around it. */
    private static void around(Graphics2D g, Vertex vertex, NetLight light, NetStrokes strokes) {
        boolean selected = light.selected().contains(vertex.id());
        if (!selected && !light.highlighted().contains(vertex.id())) {
            return;
        }
        g.setColor((selected ? SemanticColor.ACCENT : SemanticColor.CRITICAL).get());
        g.setStroke(strokes.thick());
        if (vertex.kind() == Kind.PLACE) {
            g.draw(circle(vertex, NetDrawing.PLACE_RADIUS + 3));
        } else {
            g.draw(rectangle(vertex.box().grown(4)));
        }
    }

    private static void transition(Graphics2D g, Vertex vertex, double firing) {
        if (firing > 0) {
            g.setColor(SemanticColor.NET_FIRING.withAlpha((int) (160 * firing)));
            g.fill(rectangle(vertex.box().grown(GLOW * firing)));
        }
        SemanticColor still = vertex.recovery() ? SemanticColor.NET_RECOVERY : SemanticColor.NET_TRANSITION;
        g.setColor((firing > 0 ? SemanticColor.NET_FIRING : still).get());
        if (vertex.disabled()) {
            g.draw(rectangle(vertex.box().grown(-1)));
        } else {
            g.fill(rectangle(vertex.box()));
        }
    }

    private static void place(Graphics2D g, Vertex vertex, boolean active, NetStrokes strokes) {
        SemanticColor rim = vertex.start()
                ? SemanticColor.NET_START
                : vertex.end()
                        ? SemanticColor.NET_END
                        : vertex.recovery() ? SemanticColor.NET_RECOVERY : SemanticColor.NET_PLACE;
        g.setColor(SemanticColor.NET_PLACE_FILL.get());
        g.fill(circle(vertex, NetDrawing.PLACE_RADIUS - 1));
        if (vertex.start() || vertex.end()) {
            g.setColor(rim.withAlpha(56));
            g.fill(circle(vertex, NetDrawing.PLACE_RADIUS - 1));
        }
        if (active) {
            g.setColor(SemanticColor.NET_ACTIVE.withAlpha(40));
            g.fill(circle(vertex, NetDrawing.PLACE_RADIUS - 1));
        }
        g.setColor((active && rim == SemanticColor.NET_PLACE ? SemanticColor.NET_ACTIVE : rim).get());
        g.setStroke(active ? strokes.thick() : strokes.rim());
        g.draw(circle(vertex, NetDrawing.PLACE_RADIUS - 1));
        if (vertex.subMission()) {
            g.setStroke(strokes.rim());
            g.draw(circle(vertex, NetDrawing.PLACE_RADIUS - 1 - RING));
        }
    }

    private static boolean isMissing(Label label) {
        return label.text().lines().get(0).style() == TextStyle.MISSING;
    }

    /** The mark of an edge without any requirement yet. */
    private static void missing(Graphics2D g, DrawingBox box) {
        double x = box.x() + box.width() / 2;
        double y = box.y() + box.height() / 2;
        double radius = box.width() / 2;
        g.setColor(SemanticColor.WARNING_FILL.get());
        g.fill(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius));
        g.setColor(SemanticColor.ON_WARNING.get());
        g.setFont(NetFonts.of(TextStyle.MISSING));
        g.drawString("!", (float) (x - NetFonts.width("!", TextStyle.MISSING) / 2), (float) (y + 4.8));
    }

    private static void write(Graphics2D g, Label label) {
        double top = label.y();
        if (isMissing(label)) {
            missing(g, label.box());
            return;
        }
        for (TextBlock.Line line : label.text().lines()) {
            double left = label.x() + (label.text().width() - line.width()) / 2;
            g.setFont(NetFonts.of(line.style()));
            g.setColor((line.style() == TextStyle.EDGE ? SemanticColor.ACCENT : SemanticColor.TEXT).get());
            g.drawString(line.text(), (float) left, (float) (top + line.style().size() * ASCENT));
            top += line.height();
        }
    }
}
