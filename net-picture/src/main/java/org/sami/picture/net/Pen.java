package org.sami.picture.net;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;
import org.sami.picture.Canvas;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.TextBlock;
import org.sami.spn.model.LayoutPoint;

/** A canvas that is drawn on in the colours of a theme, and the shapes of a net. */
record Pen(Canvas canvas, Theme theme) {
    private static final double ASCENT = 0.98; // of a letter's size, from the top of its line to its base line

    Color color(SemanticColor color) {
        return color.in(theme);
    }

    void fill(Shape shape, SemanticColor color) {
        canvas.fill(shape, color(color));
    }

    void draw(Shape shape, SemanticColor color, BasicStroke stroke) {
        canvas.draw(shape, color(color), stroke);
    }

    void fillAndDraw(Shape shape, SemanticColor fill, SemanticColor rim, BasicStroke stroke) {
        canvas.fillAndDraw(shape, color(fill), color(rim), stroke);
    }

    /** Writes lines below each other, from the top, at the left or each in the middle of the block. */
    void text(TextBlock block, SemanticColor color, double x, double y, boolean centred) {
        double top = y;
        for (TextBlock.Line line : block.lines()) {
            double left = centred ? x + (block.width() - line.width()) / 2 : x;
            double baseline = top + line.style().size() * ASCENT;
            canvas.text(line.text(), NetFonts.of(line.style()), color(color), left, baseline);
            top += line.height();
        }
    }

    static Rectangle2D rectangle(DrawingBox box) {
        return new Rectangle2D.Double(box.x(), box.y(), box.width(), box.height());
    }

    static Ellipse2D circle(double x, double y, double radius) {
        return new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius);
    }

    static Path2D path(List<LayoutPoint> points) {
        Path2D path = new Path2D.Double();
        path.moveTo(points.get(0).x(), points.get(0).y());
        points.stream().skip(1).forEach(point -> path.lineTo(point.x(), point.y()));
        return path;
    }
}
