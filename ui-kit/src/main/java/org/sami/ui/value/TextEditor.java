package org.sami.ui.value;

import java.awt.Rectangle;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.text.JTextComponent;
import net.miginfocom.swing.MigLayout;
import org.sami.spn.value.Value;
import org.sami.ui.look.Look;
import org.sami.ui.look.TabKey;

/**
 * A value that is typed: texts, numbers with their unit, durations, coordinates. A value that was shown stays exactly itself as long as its
 * text stays, also where the text rounds it.
 */
final class TextEditor extends ValueEditor {
    private static final int ROWS = 3;

    private final TypedText form;
    private final JTextComponent text;
    private final TextUndo undo;
    private final FieldMessage message;
    private final JPanel panel =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 4 2, fillx, hidemode 3", "[grow 1][]", "[][]"));
    private Optional<Value> shown = Optional.empty();
    private String shownText = "";

    TextEditor(ValueField field, TypedText form) {
        super(field);
        this.form = form;
        text = form.multiline() ? new JTextArea(ROWS, form.columns()) : new JTextField(form.columns());
        text.setName(field.componentName("text"));
        text.getAccessibleContext().setAccessibleName(accessibleName(field));
        if (!field.help().isEmpty()) {
            text.setToolTipText(field.help());
        }
        text.putClientProperty("JTextField.placeholderText", form.example());
        undo = TextUndo.on(text);
        message = new FieldMessage(field);
        panel.setOpaque(false);
        panel.setName(field.componentName(""));
        boolean withUnit = !field.unit().isEmpty();
        if (form.multiline()) {
            TabKey.leaves(text);
            panel.add(new JScrollPane(text), "growx, pushx, wmin 60, hmin 56, wrap");
        } else {
            panel.add(text, (withUnit ? "split 2" : "growx, wrap") + ", hmin " + Look.hitTarget());
            if (withUnit) {
                JLabel unit = new JLabel(field.unit());
                unit.setName(field.componentName("unit"));
                panel.add(unit, "wrap");
            }
        }
        panel.add(message, "growx, spanx, wmin 0");
        text.getDocument().addDocumentListener(new TextChanges(this::changed));
        text.addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) { // by Tab, from something above it
                panel.scrollRectToVisible(new Rectangle(panel.getSize()));
            }
        });
        refresh();
    }

    private static String accessibleName(ValueField field) {
        return field.unit().isEmpty() ? field.label() : field.label() + " in " + field.unit();
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public JComponent focusTarget() {
        return text;
    }

    @Override
    void leaveMessage() {
        panel.remove(message);
    }

    /** Puts a text into the field, as if the operator had typed it. */
    void type(String typed) {
        text.setText(typed);
    }

    @Override
    public Entry entry() {
        String typed = text.getText();
        return shown.isPresent() && typed.equals(shownText) ? Entry.of(shown.get()) : form.read(typed);
    }

    @Override
    protected void display(Value value) {
        shownText = form.write(value);
        shown = Optional.of(value);
        text.setText(shownText);
        text.setCaretPosition(0);
        undo.forget();
    }

    @Override
    protected void displayNothing() {
        shown = Optional.empty();
        text.setText("");
        undo.forget();
    }

    @Override
    public void setEditable(boolean editable) {
        text.setEditable(editable);
        message.setVisible(editable);
    }

    @Override
    protected void refresh() {
        Entry entry = entry();
        message.show(entry);
        boolean wrong = entry instanceof Entry.Missing missing && missing.wrong();
        text.putClientProperty("JComponent.outline", wrong ? "error" : null);
    }
}
