package org.sami.ui.map;

import java.awt.Cursor;
import org.sami.ui.canvas.CanvasTool;

/** What the pointer and the keys do on a map. */
interface MapTool extends CanvasTool<MapPointer> {
    /** A key of {@link MapKey}; false where the map may have it. */
    default boolean key(MapKey key) {
        return false;
    }

    /** Paints lines and marks, on top of all layers and below all names. */
    default void paint(MapPaint paint) {}

    /** Writes what it has to say, such as lengths; the names of layers make room for it. */
    default void paintNames(MapPaint paint) {}

    /** How the pointer looks. */
    default Cursor cursor() {
        return Cursor.getDefaultCursor();
    }

    /** Whether its points snap to what layers offer. */
    default boolean snaps() {
        return false;
    }
}
