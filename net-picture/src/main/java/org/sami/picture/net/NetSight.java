package org.sami.picture.net;

import org.sami.spn.drawing.DrawingBox;

/**
 * The part of a net that is seen, and how large.
 *
 * @param shown what lies outside of it need not be painted, in drawing units
 * @param scale how many pixels a drawing unit has
 * @param own how many it has at the net's own size, where its letters are as large as those of the window
 */
public record NetSight(DrawingBox shown, double scale, double own) {
    private static final double LEAST_ZOOM_OF_TEXT = 0.6; // smaller than that nobody reads it

    /** How large the net is seen, 1 at its own size. */
    double zoom() {
        return scale / own;
    }

    /** How many drawing units a pixel has at the net's own size. */
    double unit() {
        return own / scale;
    }

    /** Whether the net's words are read at this size. */
    boolean hasWords() {
        return scale >= LEAST_ZOOM_OF_TEXT * own;
    }
}
