package org.sami.ui.value;

import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;

/** Runs an action after each change of a text. */
public record TextChanges(Runnable action) implements DocumentListener {
    @Override
    public void insertUpdate(DocumentEvent event) {
        action.run();
    }

    @Override
    public void removeUpdate(DocumentEvent event) {
        action.run();
    }

    @Override
    public void changedUpdate(DocumentEvent event) {
        // attributes of plain text say nothing of the value
    }
}
