package org.sami.picture.net;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.sami.palette.ProxyMarks;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;
import org.sami.picture.Canvas;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.Label;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.drawing.TextStyle;
import org.sami.spn.model.LayoutPoint;

/**
 * Paints a net in drawing units: places as circles, transitions as bars (thesis, Figure 3.1), tokens as chips. The painter of windows, exports and reports.
 */
public final class NetPainter {
    private static final double ARROW = 9;
    private static final double ARROW_ANGLE = 0.42;
    private static final double RING = 5; // between the two circles of a place with a sub-mission
    private static final double RADIUS = NetDrawing.PLACE_RADIUS - 1; // its rim lies half outside
    private static final double GLOW = 7;
    private static final double TINT_OF_ENDS = 0.22;
    private static final double TINT_OF_ACTIVE = 0.16;
    private static final BasicStroke BAR = new BasicStroke(2);

    private final Pen pen;
    private final NetFigure net;
    private final NetSight sight;
    private final NetLight light;
    private final NetStrokes strokes;
    private final FramePainter frames;
    private final TokenPainter tokens;

    private NetPainter(Pen pen, ProxyMarks marks, NetFigure net, NetSight sight) {
        this.pen = pen;
        this.net = net;
        this.sight = sight;
        light = net.light();
        strokes = NetStrokes.at(sight.zoom());
        frames = new FramePainter(net.scene().frames(), pen.theme());
        tokens = new TokenPainter(pen, marks, net.marking());
    }

    /**
     * Paints what is seen of a net.
     *
     * @param canvas in drawing units
     * @param marks which colour and shape stand for each proxy
     */
    public static void paint(Canvas canvas, Theme theme, ProxyMarks marks, NetFigure net, NetSight sight) {
        new NetPainter(new Pen(canvas, theme), marks, net, sight).paint();
    }

    private void paint() {
        NetScene scene = net.scene();
        DrawingBox shown = sight.shown();
        boolean words = sight.hasWords();
        frames.paint(pen, light.selected(), words ? 1 : sight.unit());
        scene.notes().stream()
                .filter(note -> shown.intersects(note.box()))
                .forEach(note ->
                        NotePainter.paint(pen, note, light.selected().contains(NetScene.idOf(note.index())), words));
        List<Edge> edges = scene.edges().stream()
                .filter(edge -> shown.intersects(box(edge)))
                .toList();
        List<Label> labels = scene.labels().stream()
                .filter(label -> shown.intersects(label.box()))
                .toList();
        edges.forEach(this::edge);
        if (words) { // a line that crosses a text must not show through it
            labels.forEach(label -> pen.canvas().fill(Pen.rectangle(label.box().grown(1)), frames.below(label.box())));
        }
        edges.forEach(this::arrow);
        scene.silhouettes().forEach(this::silhouette);
        scene.vertices().stream()
                .filter(vertex -> shown.intersects(vertex.box().grown(GLOW)))
                .forEach(this::vertex);
        if (words) {
            labels.forEach(this::label);
        } else {
            FarNames.paint(pen, net, sight, frames);
            labels.stream().filter(NetPainter::isMissing).forEach(label -> missing(label.box())); // seen from afar, too
        }
        ChangePainter.paint(pen, sight.scale(), scene, light.changes());
        BadgePainter.paint(pen, scene, net.badges(), sight);
    }

    /** The box around an edge with its arrow. */
    private static DrawingBox box(Edge edge) {
        Rectangle2D box = Pen.path(edge.points()).getBounds2D();
        return new DrawingBox(box.getX(), box.getY(), box.getWidth(), box.getHeight()).grown(ARROW);
    }

    private SemanticColor color(Edge edge) {
        if (light.selected().contains(edge.id())) {
            return SemanticColor.ACCENT;
        }
        if (light.highlighted().contains(edge.id())) {
            return SemanticColor.CRITICAL;
        }
        return edge.recovery() ? SemanticColor.NET_RECOVERY : SemanticColor.NET_EDGE;
    }

    private void edge(Edge edge) {
        BasicStroke stroke =
                light.isLit(edge.id()) ? strokes.thick() : edge.unconditional() ? strokes.dashed() : strokes.thin();
        pen.draw(Pen.path(edge.points()), color(edge), stroke);
    }

    private void arrow(Edge edge) {
        List<LayoutPoint> points = edge.points();
        LayoutPoint tip = points.get(points.size() - 1);
        LayoutPoint before = points.get(points.size() - 2);
        double angle = Math.atan2(tip.y() - before.y(), tip.x() - before.x());
        Path2D head = Pen.path(List.of(tip, behind(tip, angle + ARROW_ANGLE), behind(tip, angle - ARROW_ANGLE)));
        head.closePath();
        pen.fill(head, color(edge));
    }

    private static LayoutPoint behind(LayoutPoint tip, double angle) {
        return new LayoutPoint(tip.x() - ARROW * Math.cos(angle), tip.y() - ARROW * Math.sin(angle));
    }

    private void silhouette(Vertex vertex) {
        boolean place = vertex.kind() == Kind.PLACE;
        pen.fill(place ? circle(vertex, RADIUS) : Pen.rectangle(vertex.box()), SemanticColor.NET_RECOVERY);
    }

    private static Ellipse2D circle(Vertex vertex, double radius) {
        return Pen.circle(vertex.centre().x(), vertex.centre().y(), radius);
    }

    private void vertex(Vertex vertex) {
        around(vertex);
        if (vertex.kind() == Kind.TRANSITION) {
            transition(vertex, light.firing().applyAsDouble(vertex.id()));
            disabled(vertex, NetDrawing.PLACE_RADIUS / 2);
        } else {
            place(vertex);
            tokens.paint(vertex);
            disabled(vertex, NetDrawing.PLACE_RADIUS * 0.7);
        }
    }

    /** A stroke through an element that is left out while the plan is tried; "disabled" is written next to it. */
    private void disabled(Vertex vertex, double reach) {
        if (vertex.disabled()) {
            double x = vertex.centre().x();
            double y = vertex.centre().y();
            Line2D stroke = new Line2D.Double(x - reach, y + reach, x + reach, y - reach);
            pen.draw(stroke, SemanticColor.WARNING, strokes.thick());
        }
    }

    /** What is selected or spoken of has a band around it. */
    private void around(Vertex vertex) {
        if (light.isLit(vertex.id())) {
            boolean selected = light.selected().contains(vertex.id());
            pen.draw(
                    vertex.kind() == Kind.PLACE
                            ? circle(vertex, NetDrawing.PLACE_RADIUS + 3)
                            : Pen.rectangle(vertex.box().grown(4)),
                    selected ? SemanticColor.ACCENT : SemanticColor.CRITICAL,
                    strokes.thick());
        }
    }

    private void transition(Vertex vertex, double firing) {
        if (firing > 0) {
            pen.canvas()
                    .fill(
                            Pen.rectangle(vertex.box().grown(GLOW * firing)),
                            SemanticColor.NET_FIRING.withAlpha((int) (160 * firing), pen.theme()));
        }
        SemanticColor still = vertex.recovery() ? SemanticColor.NET_RECOVERY : SemanticColor.NET_TRANSITION;
        SemanticColor color = firing > 0 ? SemanticColor.NET_FIRING : still;
        if (vertex.disabled()) {
            pen.draw(Pen.rectangle(vertex.box().grown(-1)), color, BAR);
        } else {
            pen.fill(Pen.rectangle(vertex.box()), color);
        }
    }

    private void place(Vertex vertex) {
        boolean active = net.marking().isActive(vertex.id());
        SemanticColor rim = vertex.start()
                ? SemanticColor.NET_START
                : vertex.end()
                        ? SemanticColor.NET_END
                        : vertex.recovery() ? SemanticColor.NET_RECOVERY : SemanticColor.NET_PLACE;
        SemanticColor line = active && rim == SemanticColor.NET_PLACE ? SemanticColor.NET_ACTIVE : rim;
        Color inside = vertex.start() || vertex.end()
                ? rim.over(SemanticColor.NET_PLACE_FILL, TINT_OF_ENDS, pen.theme())
                : active
                        ? line.over(SemanticColor.NET_PLACE_FILL, TINT_OF_ACTIVE, pen.theme())
                        : pen.color(SemanticColor.NET_PLACE_FILL);
        pen.canvas()
                .fillAndDraw(circle(vertex, RADIUS), inside, pen.color(line), active ? strokes.thick() : strokes.rim());
        if (vertex.subMission()) {
            pen.draw(circle(vertex, RADIUS - RING), line, strokes.rim());
        }
    }

    private static boolean isMissing(Label label) {
        return label.text().lines().get(0).style() == TextStyle.MISSING;
    }

    /** The mark of an edge without any requirement yet. */
    private void missing(DrawingBox box) {
        double x = box.x() + box.width() / 2;
        double y = box.y() + box.height() / 2;
        pen.fill(Pen.circle(x, y, box.width() / 2), SemanticColor.WARNING_FILL);
        double left = x - NetFonts.width("!", TextStyle.MISSING) / 2;
        pen.canvas().text("!", NetFonts.of(TextStyle.MISSING), pen.color(SemanticColor.ON_WARNING), left, y + 4.8);
    }

    private void label(Label label) {
        if (isMissing(label)) {
            missing(label.box());
        } else {
            boolean requirement = label.text().lines().get(0).style() == TextStyle.EDGE;
            pen.text(label.text(), requirement ? SemanticColor.ACCENT : SemanticColor.TEXT, label.x(), label.y(), true);
        }
    }
}
