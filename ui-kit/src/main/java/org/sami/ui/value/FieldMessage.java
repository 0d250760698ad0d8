package org.sami.ui.value;

import org.sami.palette.SemanticColor;

/** The line below a field that says why there is no value yet. It keeps its height when it is empty, so that nothing moves. */
final class FieldMessage extends NoteLabel {
    FieldMessage(ValueField field) {
        super(" ");
        setName(field.componentName("message"));
    }

    /** Says what an entry says; quietly while nothing was entered, else in the colour of warnings with a mark before it. */
    void show(Entry entry) {
        if (entry instanceof Entry.Missing missing) {
            setText((missing.wrong() ? "▲ " : "") + missing.why());
            setColor(missing.wrong() ? SemanticColor.CRITICAL : SemanticColor.MUTED);
            setToolTipText(missing.why());
        } else {
            setText(" ");
            setToolTipText(null);
        }
    }
}
