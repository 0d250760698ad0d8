package org.sami.ui.map;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import org.sami.palette.Contrast;

/** What lies around a line on imagery, of which nobody knows how dark it is: black around light colours, white around dark ones. */
final class Casing {
    private static final double ALPHA = 0.85;
    private static final float WIDER = 3; // than the line, in pixels

    private Casing() {}

    /** The colour around a line of a colour. */
    static Color of(Color line) {
        return Painting.alpha(Contrast.inkOn(line), ALPHA);
    }

    /** How a casing of a line is drawn. */
    static BasicStroke stroke(BasicStroke line) {
        return new BasicStroke(line.getLineWidth() + WIDER, line.getEndCap(), BasicStroke.JOIN_BEVEL);
    }

    /** Draws what lies around a shape on imagery, and nothing on another map; colour and stroke are the line's afterwards. */
    static void draw(MapPaint paint, Shape shape, Color color, BasicStroke line) {
        Graphics2D g = paint.g();
        if (paint.imagery()) {
            g.setColor(of(color));
            g.setStroke(stroke(line));
            g.draw(shape);
        }
        g.setColor(color);
        g.setStroke(line);
    }
}
