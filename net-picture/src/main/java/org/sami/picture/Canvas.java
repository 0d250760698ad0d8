package org.sami.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;

/** What pictures are painted on: a window, pixels, SVG, PDF. Coordinates are those of the picture, y downwards; colours may be translucent. */
public interface Canvas {
    /** Fills a shape. */
    void fill(Shape shape, Color color);

    /** Draws the outline of a shape, or a line. */
    void draw(Shape shape, Color color, BasicStroke stroke);

    /** Fills a shape and draws its outline. */
    default void fillAndDraw(Shape shape, Color fill, Color rim, BasicStroke stroke) {
        fill(shape, fill);
        draw(shape, rim, stroke);
    }

    /** Writes a line of text from its left end on its base line. */
    void text(String text, Font font, Color color, double x, double baseline);
}
