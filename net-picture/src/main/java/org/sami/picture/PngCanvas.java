package org.sami.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.sami.spn.drawing.TextBlock;

/** Paints pixels. */
final class PngCanvas implements Canvas {
    private final Graphics2D g;

    PngCanvas(Graphics2D g) {
        this.g = g;
    }

    @Override
    public void circle(Point2D centre, double radius, Color fill, Color rim, double rimWidth) {
        Ellipse2D circle = new Ellipse2D.Double(centre.getX() - radius, centre.getY() - radius, 2 * radius, 2 * radius);
        g.setColor(fill);
        g.fill(circle);
        g.setColor(rim);
        g.setStroke(new BasicStroke((float) rimWidth));
        g.draw(circle);
    }

    @Override
    public void box(Rectangle2D box, Color fill) {
        g.setColor(fill);
        g.fill(box);
    }

    @Override
    public void line(List<Point2D> points, Color color, double width, boolean dashed) {
        float[] dash = dashed ? new float[] {6, 5} : null;
        g.setColor(color);
        g.setStroke(new BasicStroke((float) width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dash, 0));
        g.draw(path(points));
    }

    @Override
    public void polygon(List<Point2D> corners, Color fill) {
        Path2D path = path(corners);
        path.closePath();
        g.setColor(fill);
        g.fill(path);
    }

    private static Path2D path(List<Point2D> points) {
        Path2D path = new Path2D.Double();
        path.moveTo(points.get(0).getX(), points.get(0).getY());
        points.stream().skip(1).forEach(point -> path.lineTo(point.getX(), point.getY()));
        return path;
    }

    @Override
    public void text(TextBlock.Line line, double x, double baseline) {
        g.setFont(NetFonts.of(line.style()));
        g.setColor(NetFonts.color(line.style()));
        g.drawString(line.text(), (float) x, (float) baseline);
    }
}
