package org.sami.ui.value;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.text.JTextComponent;
import javax.swing.undo.UndoManager;

/** Lets what is typed be taken back with Ctrl+Z and made again with Ctrl+Y or Ctrl+Shift+Z. */
final class TextUndo {
    private final UndoManager edits = new UndoManager();

    private TextUndo() {}

    /** Gives a text undo; its result forgets all edits on request, such as after a value was shown. */
    static TextUndo on(JTextComponent text) {
        TextUndo undo = new TextUndo();
        text.getDocument().addUndoableEditListener(undo.edits);
        Keys.bind(text, KeyEvent.VK_Z, InputEvent.CTRL_DOWN_MASK, "undo-text", undo::undo);
        Keys.bind(text, KeyEvent.VK_Y, InputEvent.CTRL_DOWN_MASK, "redo-text", undo::redo);
        Keys.bind(text, KeyEvent.VK_Z, InputEvent.CTRL_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK, "redo-text", undo::redo);
        return undo;
    }

    private void undo() {
        if (edits.canUndo()) {
            edits.undo();
        }
    }

    private void redo() {
        if (edits.canRedo()) {
            edits.redo();
        }
    }

    void forget() {
        edits.discardAllEdits();
    }
}
