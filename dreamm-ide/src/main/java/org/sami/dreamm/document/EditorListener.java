package org.sami.dreamm.document;

/** Hears what the author looks at, on the event thread. */
public interface EditorListener {
    /** Another plan is open, or none. */
    default void planOpened() {}

    /** The net is shown in another mode. */
    default void modeChanged() {}

    /** Other elements are selected. */
    default void selectionChanged() {}

    /** Other elements are spoken of, such as those of a finding. */
    default void highlightChanged() {}
}
