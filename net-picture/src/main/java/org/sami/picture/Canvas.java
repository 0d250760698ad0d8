package org.sami.picture;

import java.awt.Color;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.sami.spn.drawing.TextBlock;

/** What a picture of a net is painted on, in pixels at scale 1. */
public interface Canvas {
    /** A circle with its rim. */
    void circle(Point2D centre, double radius, Color fill, Color rim, double rimWidth);

    /** A rectangle without a rim. */
    void box(Rectangle2D box, Color fill);

    /** A line through some points. */
    void line(List<Point2D> points, Color color, double width, boolean dashed);

    /** A filled polygon. */
    void polygon(List<Point2D> corners, Color fill);

    /** A line of text, from its left end on its base line. */
    void text(TextBlock.Line line, double x, double baseline);
}
