package org.sami.dreamm.canvas;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.Optional;
import org.sami.palette.SemanticColor;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.Vertex;

/**
 * The two handles at the right of a vertex under the pointer: from the upper one an edge is drawn, the lower one offers what can come next. They
 * are as large on every zoom.
 *
 * @param unit drawing units of a pixel
 * @param offersNext whether there is the lower one
 */
record Handles(Vertex vertex, double unit, boolean offersNext) {
    private static final double RADIUS = 10;
    private static final double HANDLE_OFFSET = 15;
    private static final double HANDLE_SPACING = 12;
    private static final double REACH = 10; // around both, so that they stay while the pointer goes there

    private DrawingBox handle(double dy) {
        DrawingBox box = vertex.box();
        double radius = RADIUS * unit;
        return new DrawingBox(
                box.maxX() + (HANDLE_OFFSET - RADIUS) * unit,
                vertex.centre().y() + dy * unit - radius,
                2 * radius,
                2 * radius);
    }

    /** From where an edge is drawn. */
    DrawingBox connect() {
        return handle(-HANDLE_SPACING);
    }

    /** What opens the menu of what can come next; nowhere where that is not offered. */
    Optional<DrawingBox> append() {
        return offersNext ? Optional.of(handle(HANDLE_SPACING)) : Optional.empty();
    }

    /** Whether a point is on what opens that menu. */
    boolean isAppendAt(double x, double y) {
        return append().filter(box -> box.contains(x, y)).isPresent();
    }

    /** Whether a point is on one of the handles. */
    boolean isAt(double x, double y) {
        return connect().contains(x, y) || isAppendAt(x, y);
    }

    /** Whether a point is so near that they stay. */
    boolean isNear(double x, double y) {
        DrawingBox first = vertex.box().union(connect());
        return append().map(first::union).orElse(first).grown(REACH * unit).contains(x, y);
    }

    void paint(Graphics2D g) {
        g.setStroke(new BasicStroke((float) (2 * unit)));
        double arm = 4 * unit;
        DrawingBox arrow = connect();
        double y = arrow.y() + RADIUS * unit;
        double tip = arrow.maxX() - arm;
        disc(g, arrow);
        g.draw(new Line2D.Double(arrow.x() + arm, y, tip, y));
        g.draw(new Line2D.Double(tip - arm, y - arm, tip, y));
        g.draw(new Line2D.Double(tip - arm, y + arm, tip, y));
        append().ifPresent(plus -> paintPlus(g, plus, arm));
    }

    private static void paintPlus(Graphics2D g, DrawingBox plus, double arm) {
        double middleX = plus.x() + plus.width() / 2;
        double middleY = plus.y() + plus.height() / 2;
        disc(g, plus);
        g.draw(new Line2D.Double(middleX - arm, middleY, middleX + arm, middleY));
        g.draw(new Line2D.Double(middleX, middleY - arm, middleX, middleY + arm));
    }

    private static void disc(Graphics2D g, DrawingBox box) {
        g.setColor(SemanticColor.ACCENT.get());
        g.fill(new Ellipse2D.Double(box.x(), box.y(), box.width(), box.height()));
        g.setColor(SemanticColor.ON_ACCENT.get());
    }
}
