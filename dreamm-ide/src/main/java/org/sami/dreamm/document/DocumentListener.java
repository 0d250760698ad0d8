package org.sami.dreamm.document;

/** Hears what becomes of a document, on the event thread. */
public interface DocumentListener {
    /** The project is another one. */
    void changed(DocumentChange change);

    /** Its file, or whether it has changes that are not in the file, is another; also after each {@link #changed}. */
    default void stateChanged() {}
}
