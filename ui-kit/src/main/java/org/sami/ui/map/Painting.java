package org.sami.ui.map;

import java.awt.BasicStroke;
import java.awt.Color;
import org.sami.ui.look.Look;

/** Colours and lines that several layers paint with, at the scale in force. */
final class Painting {
    private Painting() {}

    /** A colour that lets some of what lies below shine through: 0 is invisible, 1 hides it. */
    static Color alpha(Color color, double alpha) {
        return new Color(color.getRed(), color.getGreen(), color.getBlue(), (int) Math.round(255 * alpha));
    }

    /** A line of that width in logical pixels. */
    static BasicStroke line(double width) {
        return new BasicStroke(px(width), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    /** A line that ends where it ends: single legs of it are painted several times as fast as those of a round one. */
    static BasicStroke butt(double width) {
        return new BasicStroke(px(width), BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL);
    }

    /** A dashed line: width, dash and gap in logical pixels. */
    static BasicStroke dashed(double width, double dash, double gap) {
        return new BasicStroke(
                px(width), BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, new float[] {px(dash), px(gap)}, 0);
    }

    /** Logical pixels at the scale in force. */
    static float px(double logical) {
        return (float) (logical * Look.scalePercent() / 100);
    }
}
