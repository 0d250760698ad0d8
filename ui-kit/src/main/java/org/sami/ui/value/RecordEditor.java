package org.sami.ui.value;

import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** A record as a form (Algorithm 6): its fields set off from what stands around it. */
final class RecordEditor extends ValueEditor {
    private final FieldsPanel fields;
    private final JPanel panel = new JPanel(new MigLayout("novisualpadding, insets 0 12 0 0, fillx", "[grow,fill]"));

    RecordEditor(ValueField field, FieldsPanel fields) {
        super(field);
        this.fields = fields;
        panel.setOpaque(false);
        panel.setName(field.componentName(""));
        panel.add(fields.component());
        fields.addListener(this::changed);
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public JComponent focusTarget() {
        return fields.focusTarget();
    }

    @Override
    public Entry entry() {
        String type = ((ValueType.Named) field().type()).name();
        return fields.values()
                .map(values -> Entry.of(new RecordValue(type, values)))
                .orElseGet(() -> fields.missing().orElseThrow());
    }

    @Override
    protected void display(Value value) {
        RecordValue shown = (RecordValue) value;
        fields.editors().forEach((name, editor) -> {
            if (shown.field(name).isPresent()) {
                editor.show(shown.field(name).get());
            } else {
                editor.clear();
            }
        });
    }

    @Override
    protected void displayNothing() {
        fields.editors().values().forEach(ValueEditor::clear);
    }

    @Override
    public void setEditable(boolean editable) {
        fields.setEditable(editable);
    }
}
