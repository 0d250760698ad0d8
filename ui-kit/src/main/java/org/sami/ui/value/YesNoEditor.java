package org.sami.ui.value;

import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.Value;

/** Yes or no, as two buttons of which one is down or none yet (component {@code YesNoButtons}). */
final class YesNoEditor extends ValueEditor {
    private final JToggleButton yes = button("Yes", "yes", 'Y');
    private final JToggleButton no = button("No", "no", 'N');
    private final ButtonGroup group = new ButtonGroup();
    private final FieldMessage message;
    private Runnable pressed = () -> {};
    private final JPanel panel =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 8 2, hidemode 3", "[sg][sg]", "[40:pref][]"));

    YesNoEditor(ValueField field) {
        super(field);
        message = new FieldMessage(field);
        group.add(yes);
        group.add(no);
        panel.setOpaque(false);
        panel.setName(field.componentName(""));
        panel.add(yes, "grow, wmin 88");
        panel.add(no, "grow, wmin 88, wrap");
        panel.add(message, "spanx");
        refresh();
    }

    private JToggleButton button(String words, String part, char mnemonic) {
        JToggleButton button = new ChoiceButton(words);
        button.setName(field().componentName(part));
        button.setMnemonic(mnemonic);
        button.setToolTipText(words + " (Alt+" + mnemonic + ")");
        button.getAccessibleContext().setAccessibleName(field().label() + ": " + words);
        button.addActionListener(event -> {
            changed();
            pressed.run();
        });
        return button;
    }

    @Override
    void leaveMessage() {
        panel.remove(message);
    }

    /** Calls a listener after the operator has pressed a button; the entry has that answer then. */
    void onPressed(Runnable listener) {
        pressed = listener;
    }

    /** Chooses as a key does: the button is down, and was not pressed. */
    void choose(boolean answer) {
        if (yes.isEnabled()) {
            group.setSelected((answer ? yes : no).getModel(), true);
            changed();
        }
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public JComponent focusTarget() {
        return no.isSelected() ? no : yes;
    }

    @Override
    public Entry entry() {
        return yes.isSelected() || no.isSelected()
                ? Entry.of(new BooleanValue(yes.isSelected()))
                : Entry.nothing("Choose yes or no");
    }

    @Override
    protected void display(Value value) {
        group.setSelected((((BooleanValue) value).value() ? yes : no).getModel(), true);
    }

    @Override
    protected void displayNothing() {
        group.clearSelection();
    }

    @Override
    public void setEditable(boolean editable) {
        yes.setEnabled(editable);
        no.setEnabled(editable);
        message.setVisible(editable);
    }

    @Override
    protected void refresh() {
        message.show(entry());
    }
}
