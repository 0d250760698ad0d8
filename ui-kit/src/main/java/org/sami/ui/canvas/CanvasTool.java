package org.sami.ui.canvas;

/**
 * What the pointer does on a canvas.
 *
 * @param <P> what is known of where the pointer is
 */
public interface CanvasTool<P> {
    /** The button went down. If the tool takes the pointer, dragging is the tool's and not the view's. */
    default boolean press(P pointer) {
        return false;
    }

    /** The pointer that was taken is elsewhere. */
    default void drag(P pointer) {}

    /** The pointer that was taken is free again. */
    default void release(P pointer) {}

    /** A click that nobody took before. */
    default void click(P pointer) {}

    /** The pointer moved with no button down. */
    default void move(P pointer) {}
}
