package org.sami.spn.model;

import java.util.Objects;

/**
 * A frame on the drawing, with a title, around vertices that belong together. It means nothing at run time.
 *
 * @param at its left upper corner, in units of the layout
 * @param width in units of the layout, more than 0
 * @param height in units of the layout, more than 0
 */
public record NetFrame(String title, FrameColor color, LayoutPoint at, double width, double height) {
    public NetFrame {
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(color, "color");
        Objects.requireNonNull(at, "at");
        if (!(width > 0) || !(height > 0)) {
            throw new IllegalArgumentException("a frame of " + width + " by " + height);
        }
    }

    /** The same frame with another title. */
    public NetFrame withTitle(String title) {
        return new NetFrame(title, color, at, width, height);
    }

    /** The same frame in another colour. */
    public NetFrame withColor(FrameColor color) {
        return new NetFrame(title, color, at, width, height);
    }

    /** The same frame elsewhere. */
    public NetFrame withAt(LayoutPoint at) {
        return new NetFrame(title, color, at, width, height);
    }

    /** The same frame in another size. */
    public NetFrame withSize(double width, double height) {
        return new NetFrame(title, color, at, width, height);
    }
}
