package org.sami.dreamm.canvas;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import org.sami.palette.SemanticColor;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.Vertex;

/**
 * The two handles at the right of a vertex under the pointer: from the upper one an edge is drawn, the lower one offers what can come next. They
 * are as large on every zoom.
 *
 * @param unit drawing units of a pixel
 */
record Handles(Vertex vertex, double unit) {
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

    /** What opens the menu of what can come next. */
    DrawingBox append() {
        return handle(HANDLE_SPACING);
    }

    /** Whether a point is on one of the handles. */
    boolean isAt(double x, double y) {
        return connect().contains(x, y) || append().contains(x, y);
    }

    /** Whether a point is so near that they stay. */
    boolean isNear(double x, double y) {
        return vertex.box().union(connect()).union(append()).grown(REACH * unit).contains(x, y);
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
        DrawingBox plus = append();
        double middleX = plus.x() + RADIUS * unit;
        double middleY = plus.y() + RADIUS * unit;
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
