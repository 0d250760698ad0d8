package org.sami.ui.net;

import java.awt.Graphics2D;

/** What the pointer does on a net. An editor has other tools than a monitor. */
public interface NetTool {
    /** The button went down. If the tool takes the pointer, dragging is the tool's and not the view's. */
    default boolean press(NetPointer pointer) {
        return false;
    }

    /** The pointer that was taken is elsewhere. */
    default void drag(NetPointer pointer) {}

    /** The pointer that was taken is free again. */
    default void release(NetPointer pointer) {}

    /** A click that nobody took before. */
    default void click(NetPointer pointer) {}

    /** The pointer moved with no button down. */
    default void move(NetPointer pointer) {}

    /** Paints on top of the net, in drawing units. */
    default void paint(Graphics2D g) {}
}
