package org.sami.ui.value;

import javax.swing.JComponent;
import org.sami.palette.SemanticColor;
import org.sami.spn.value.Value;

/** Stands where no component was found: the reason, in words; it never has a value (thesis 5.2.4, Algorithm 4). */
final class WarningView extends ValueEditor {
    private final String reason;
    private final WrappedText text;

    WarningView(ValueField field, String reason) {
        super(field);
        this.reason = reason;
        text = new WrappedText("▲ " + reason);
        text.setName(field.componentName("warning"));
        text.setColor(SemanticColor.CRITICAL);
    }

    @Override
    public JComponent component() {
        return text;
    }

    @Override
    public JComponent focusTarget() {
        return text;
    }

    @Override
    public Entry entry() {
        return Entry.wrong(reason);
    }

    @Override
    protected void display(Value value) {
        text.setText(ValueSummary.of(value));
    }

    @Override
    protected void displayNothing() {
        text.setText("▲ " + reason);
    }

    @Override
    public void setEditable(boolean editable) {
        // there is nothing to edit in any case
    }
}
