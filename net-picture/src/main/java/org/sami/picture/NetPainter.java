package org.sami.picture;

import java.awt.Color;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
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

/** Paints a drawing as the thesis shows nets: places are circles, transitions bars; green is the start, red the end. */
final class NetPainter {
    private static final double MARGIN = 32;
    private static final double HEAD = 58;
    private static final double ARROW = 9;
    private static final double RING = 5;
    private static final double ASCENT = 0.98; // of a letter's size, from the top of its line to its base line
    private static final Color PAPER = Color.WHITE;
    private static final Color INK = new Color(0x1F2933);
    private static final Color LINE = new Color(0x52606D);
    private static final Color RECOVERY = new Color(0x98A2AD);
    private static final Color PLACE = new Color(0xF5F7FA);
    private static final Color NOTE = new Color(0xFFF9E3);
    private static final Color NOTE_RIM = new Color(0xC9B36A);
    private static final Color START = new Color(0xBFE8C7);
    private static final Color START_RIM = new Color(0x1B7F3B);
    private static final Color END = new Color(0xF7C5C0);
    private static final Color END_RIM = new Color(0xB42318);
    private static final String KEY =
            "≥ 1 Generic and Take 1 Generic of one transition are not written; dashed lines have no condition.";

    private final NetDrawing drawing;
    private final DrawingBox bounds;
    private final FramePainter frames;
    private final TextBlock title;
    private final TextBlock key = TextBlock.of(List.of(KEY), TextStyle.NOTE, NetFonts::width);

    NetPainter(NetDrawing drawing) {
        this.drawing = drawing;
        title = TextBlock.of(List.of(drawing.title()), TextStyle.TITLE, NetFonts::width);
        bounds = drawing.bounds();
        frames = new FramePainter(drawing.frames(), PAPER);
    }

    /** The picture's width, in pixels at scale 1. */
    double width() {
        double words = Math.max(title.width(), key.width());
        return Math.ceil(Math.max(bounds.width(), words) + 2 * MARGIN);
    }

    /** The picture's height. */
    double height() {
        return Math.ceil(bounds.height() + 2 * MARGIN + HEAD);
    }

    /** How far the drawing's own coordinates are moved in the picture. */
    private double dx() {
        return MARGIN - bounds.x();
    }

    private double dy() {
        return MARGIN + HEAD - bounds.y();
    }

    void paint(Canvas canvas) {
        canvas.box(new Rectangle2D.Double(0, 0, width(), height()), PAPER);
        write(canvas, title, MARGIN, MARGIN - 8);
        write(canvas, key, MARGIN, MARGIN - 8 + title.height() + 2);
        frames.paint(canvas, dx(), dy());
        drawing.notes().forEach(note -> note(canvas, note));
        drawing.edges().forEach(edge -> edge(canvas, edge));
        drawing.labels()
                .forEach(label -> clear(canvas, label)); // a line that crosses a text is not to be read through it
        drawing.edges().forEach(edge -> arrow(canvas, edge));
        drawing.vertices().forEach(vertex -> vertex(canvas, vertex));
        drawing.labels().forEach(label -> label(canvas, label));
    }

    private void note(Canvas canvas, NoteBox note) {
        Rectangle2D sheet = rectangle(note.box());
        canvas.box(sheet, NOTE_RIM);
        canvas.box(
                new Rectangle2D.Double(sheet.getX() + 1, sheet.getY() + 1, sheet.getWidth() - 2, sheet.getHeight() - 2),
                NOTE);
        double top = sheet.getY() + note.inset();
        for (TextBlock.Line line : note.text().lines()) {
            canvas.text(line, sheet.getX() + note.inset(), top + line.style().size() * ASCENT);
            top += line.height();
        }
    }

    private void edge(Canvas canvas, Edge edge) {
        List<Point2D> points = edge.points().stream().map(this::moved).toList();
        canvas.line(points, edge.recovery() ? RECOVERY : LINE, 1.4, edge.unconditional());
    }

    private void arrow(Canvas canvas, Edge edge) {
        List<LayoutPoint> points = edge.points();
        Point2D tip = moved(points.get(points.size() - 1));
        Point2D before = moved(points.get(points.size() - 2));
        double angle = Math.atan2(tip.getY() - before.getY(), tip.getX() - before.getX());
        canvas.polygon(
                List.of(tip, behind(tip, angle, 0.42), behind(tip, angle, -0.42)), edge.recovery() ? RECOVERY : LINE);
    }

    private static Point2D behind(Point2D tip, double angle, double aside) {
        return new Point2D.Double(
                tip.getX() - ARROW * Math.cos(angle + aside), tip.getY() - ARROW * Math.sin(angle + aside));
    }

    private void vertex(Canvas canvas, Vertex vertex) {
        Point2D centre = moved(vertex.centre());
        if (vertex.kind() == Kind.TRANSITION) {
            canvas.box(rectangle(vertex.box()), vertex.recovery() ? RECOVERY : INK);
            if (vertex.disabled()) { // a bar without its inside
                canvas.box(rectangle(vertex.box().grown(-2)), frames.below(vertex.box()));
                strike(canvas, centre, NetDrawing.PLACE_RADIUS / 2);
            }
            return;
        }
        Color rim = vertex.start() ? START_RIM : vertex.end() ? END_RIM : vertex.recovery() ? RECOVERY : INK;
        Color fill = vertex.start() ? START : vertex.end() ? END : PLACE;
        canvas.circle(centre, NetDrawing.PLACE_RADIUS - 1, fill, rim, 2);
        if (vertex.subMission()) {
            canvas.circle(centre, NetDrawing.PLACE_RADIUS - 1 - RING, fill, rim, 2);
        }
        if (vertex.disabled()) {
            strike(canvas, centre, NetDrawing.PLACE_RADIUS * 0.7);
        }
    }

    /** Through what is left out while the plan is tried. */
    private static void strike(Canvas canvas, Point2D centre, double reach) {
        canvas.line(
                List.of(
                        new Point2D.Double(centre.getX() - reach, centre.getY() + reach),
                        new Point2D.Double(centre.getX() + reach, centre.getY() - reach)),
                INK,
                2.4,
                false);
    }

    private Rectangle2D rectangle(DrawingBox box) {
        return new Rectangle2D.Double(box.x() + dx(), box.y() + dy(), box.width(), box.height());
    }

    private void clear(Canvas canvas, Label label) {
        DrawingBox box = label.box();
        canvas.box(
                new Rectangle2D.Double(box.x() + dx() - 2, box.y() + dy(), box.width() + 4, box.height()),
                frames.below(box));
    }

    private void label(Canvas canvas, Label label) {
        write(canvas, label.text(), label.x() + dx(), label.y() + dy());
    }

    private static void write(Canvas canvas, TextBlock block, double x, double y) {
        double top = y;
        for (TextBlock.Line line : block.lines()) {
            double left = x + (block.width() - line.width()) / 2;
            canvas.text(line, left, top + line.style().size() * ASCENT);
            top += line.height();
        }
    }

    private Point2D moved(LayoutPoint point) {
        return new Point2D.Double(point.x() + dx(), point.y() + dy());
    }
}
