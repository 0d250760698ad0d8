package org.sami.ui.value;

import java.awt.Component;
import java.util.List;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.text.JTextComponent;
import net.miginfocom.swing.MigLayout;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;
import org.sami.ui.look.Look;

/** The name of a robot: one of those that are known, or any that is typed. */
final class RobotNameEditor extends ValueEditor {
    private final JComboBox<String> box = new JComboBox<>();
    private final FieldMessage message;
    private final JPanel panel =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 4 2, fillx, hidemode 3, wrap 1", "[grow, fill]"));

    RobotNameEditor(ValueField field, List<ChoiceRow> known) {
        super(field);
        known.stream()
                .map(ChoiceRow::value)
                .filter(ProxyValue.class::isInstance)
                .map(value -> ((ProxyValue) value).proxy())
                .forEach(box::addItem);
        box.setEditable(true);
        box.setSelectedItem(null);
        box.setName(field.componentName("name"));
        box.getAccessibleContext().setAccessibleName(field.label());
        box.setToolTipText("The name of a robot: choose one, or type any");
        message = new FieldMessage(field);
        panel.setOpaque(false);
        panel.setName(field.componentName(""));
        panel.add(box, "wmin 60, hmin " + Look.hitTarget());
        panel.add(message, "wmin 0");
        text().getDocument().addDocumentListener(new TextChanges(this::changed));
        refresh();
    }

    private JTextComponent text() {
        Component editor = box.getEditor().getEditorComponent();
        return (JTextComponent) editor;
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public JComponent focusTarget() {
        return text();
    }

    @Override
    void leaveMessage() {
        panel.remove(message);
    }

    @Override
    public Entry entry() {
        String name = text().getText().strip();
        return name.isEmpty() ? Entry.nothing("Type the name of a robot") : Entry.of(new ProxyValue(name));
    }

    @Override
    protected void display(Value value) {
        box.setSelectedItem(((ProxyValue) value).proxy());
    }

    @Override
    protected void displayNothing() {
        box.setSelectedItem(null);
    }

    @Override
    public void setEditable(boolean editable) {
        box.setEnabled(editable);
        message.setVisible(editable);
    }

    @Override
    protected void refresh() {
        message.show(entry());
    }
}
