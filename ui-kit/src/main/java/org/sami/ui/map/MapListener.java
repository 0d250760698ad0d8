package org.sami.ui.map;

import java.util.List;

/** Hears what somebody does on a map, on the event thread. */
public interface MapListener {
    /** Somebody clicked while nothing is drawn. */
    default void clicked(MapClick click) {}

    /** Somebody drew a box with Shift held around these, by their ids. */
    default void boxed(List<String> items) {}

    /** Another part of the world is shown. */
    default void moved() {}

    /** Something is wrong with a base map, in one line; the map goes on without it. */
    default void problem(String text) {}

    /** There are other base maps, or others of them are shown. */
    default void baseMapsChanged() {}
}
