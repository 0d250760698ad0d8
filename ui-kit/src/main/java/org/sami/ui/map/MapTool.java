package org.sami.ui.map;

import java.awt.Cursor;

/** What the pointer and the keys do on a map. */
interface MapTool {
    /** The button went down. If the tool takes the pointer, dragging is the tool's and not the map's. */
    default boolean press(MapPointer pointer) {
        return false;
    }

    /** The pointer that was taken is elsewhere. */
    default void drag(MapPointer pointer) {}

    /** The pointer that was taken is free again. */
    default void release(MapPointer pointer) {}

    /** A click that nobody took before. */
    default void click(MapPointer pointer) {}

    /** The pointer moved with no button down. */
    default void move(MapPointer pointer) {}

    /** A key of {@link MapKey}; false where the map may have it. */
    default boolean key(MapKey key) {
        return false;
    }

    /** Paints on top of all layers. */
    default void paint(MapPaint paint) {}

    /** How the pointer looks. */
    default Cursor cursor() {
        return Cursor.getDefaultCursor();
    }

    /** Whether its points snap to what layers offer. */
    default boolean snaps() {
        return false;
    }
}
