package org.sami.palette;

import java.awt.Color;

/** How well one colour is seen on another, as WCAG 2.1 computes it: 1 (not at all) to 21 (black on white). */
public final class Contrast {
    private Contrast() {}

    /** The contrast of two opaque colours. */
    public static double of(Color one, Color other) {
        double a = luminance(one);
        double b = luminance(other);
        return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    }

    /** Black or white, whichever is read better on a colour. */
    public static Color inkOn(Color fill) {
        return of(Color.BLACK, fill) >= of(Color.WHITE, fill) ? Color.BLACK : Color.WHITE;
    }

    private static double luminance(Color color) {
        return 0.2126 * linear(color.getRed()) + 0.7152 * linear(color.getGreen()) + 0.0722 * linear(color.getBlue());
    }

    private static double linear(int channel) {
        double c = channel / 255.0;
        return c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4);
    }
}
