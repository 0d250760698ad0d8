package org.sami.ui.look;

import java.awt.FontMetrics;

/** Shortens texts that there is no room for. Whoever shows one says the whole of it in a tooltip. */
public final class ElidedText {
    private static final String LEFT_OUT = "…";

    private ElidedText() {}

    /**
     * A text without its middle: names that belong together often begin alike, and differ at the end.
     *
     * @param width in pixels; at least one letter and the sign of what is left out stay
     */
    public static String middle(String text, FontMetrics metrics, int width) {
        if (metrics.stringWidth(text) <= width) {
            return text;
        }
        int kept = text.length() - 1;
        while (kept > 1 && metrics.stringWidth(without(text, kept)) > width) {
            kept--;
        }
        return without(text, kept);
    }

    /** So many letters of a text, from its beginning and its end in turn. */
    private static String without(String text, int kept) {
        int head = (kept + 1) / 2;
        return text.substring(0, head).stripTrailing()
                + LEFT_OUT
                + text.substring(text.length() - (kept - head)).stripLeading();
    }
}
