package org.sami.dreamm.canvas;

/** Where a palette puts what was chosen by a key or a double click. On the event thread. */
public interface NetDropTarget {
    /** Adds it to the one vertex that is selected, where it can be added there; else with a vertex of its own next to it, or in the visible part. */
    void put(NetDrop drop);
}
