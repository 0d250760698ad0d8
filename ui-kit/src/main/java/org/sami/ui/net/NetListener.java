package org.sami.ui.net;

import java.util.Set;

/** Hears what somebody does with a net, on the event thread. */
public interface NetListener {
    /** Other vertices and edges are selected, by their ids. */
    default void selected(Set<String> ids) {}

    /** Somebody wants to see what is behind a vertex or an edge: a double click, or Enter. */
    default void opened(String id) {}

    /**
     * Somebody asks for a menu.
     *
     * @param id of what it is for; empty text where only the canvas is
     * @param x where, in pixels of the view
     */
    default void menu(String id, int x, int y) {}
}
