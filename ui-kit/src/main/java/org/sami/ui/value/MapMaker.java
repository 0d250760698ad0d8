package org.sami.ui.value;

import org.sami.ui.map.MapView;

/** Makes the maps on which places are drawn and compared: an editor has one of its own. */
@FunctionalInterface
public interface MapMaker {
    /** Maps with nothing but a grid. */
    MapMaker PLAIN = MapView::new;

    /** A map that shows what is known around, such as where robots are; called on the event thread. */
    MapView make();

    /** How high a map in a form is at first, in logical pixels. */
    default int height() {
        return 240;
    }

    /** Somebody has made a map in a form higher or lower. */
    default void keepHeight(int height) {}
}
