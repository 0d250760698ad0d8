package org.sami.ui.value;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;

/**
 * What lists and maps have in common: parts one below the other, to which more are added, of which some are removed or moved.
 *
 * @param <P> what a part is made of
 */
abstract class PartsEditor<P> extends ValueEditor {
    private final List<P> parts = new ArrayList<>();
    private final JPanel rows =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 4 2, fillx, hidemode 3, wrap 2", "[grow,fill][]"));
    private final JButton add = new JButton();
    private final FieldMessage message;
    private final JPanel panel = new JPanel(
            new MigLayout("novisualpadding, insets 0 12 0 0, gap 4 2, fillx, hidemode 3, wrap 1", "[grow,fill]"));
    private boolean editable = true;
    private int made;

    PartsEditor(ValueField field, String addWords) {
        super(field);
        message = new FieldMessage(field);
        add.setText(addWords);
        add.setName(field.componentName("add"));
        add.setToolTipText(addWords + " at the end");
        add.addActionListener(event -> {
            focusOf(append()).requestFocusInWindow();
            changed();
        });
        panel.setOpaque(false);
        rows.setOpaque(false);
        panel.setName(field.componentName(""));
        panel.add(rows);
        panel.add(add, "growx 0, hmin 32, split 2");
        panel.add(message, "growx");
    }

    /** Makes a part without value; its number never comes again. */
    abstract P makePart(int number);

    /** What a part is put into a window with. */
    abstract JComponent componentOf(P part);

    abstract JComponent focusOf(P part);

    abstract void setPartEditable(P part, boolean editable);

    final List<P> parts() {
        return Collections.unmodifiableList(parts);
    }

    /** Adds a part without value at the end. */
    final P append() {
        P part = makePart(++made);
        parts.add(part);
        layOut();
        return part;
    }

    final void removeAllParts() {
        parts.clear();
        layOut();
    }

    private void layOut() {
        rows.removeAll();
        for (int i = 0; i < parts.size(); i++) {
            rows.add(componentOf(parts.get(i)));
            rows.add(buttons(i), "aligny top");
            setPartEditable(parts.get(i), editable);
        }
        rows.revalidate();
        rows.repaint();
    }

    private JComponent buttons(int index) {
        JPanel buttons = new JPanel(new MigLayout("novisualpadding, insets 0, gap 2", "[]", "[32:pref]"));
        buttons.setOpaque(false);
        buttons.setVisible(editable);
        String number = String.valueOf(index + 1);
        buttons.add(
                button("↑", "up-" + number, "Move number " + number + " up", index > 0, () -> swap(index, index - 1)));
        buttons.add(button(
                "↓",
                "down-" + number,
                "Move number " + number + " down",
                index < parts.size() - 1,
                () -> swap(index, index + 1)));
        buttons.add(button("✕", "remove-" + number, "Remove number " + number, true, () -> parts.remove(index)));
        return buttons;
    }

    private JButton button(String sign, String part, String help, boolean enabled, Runnable action) {
        JButton button = new JButton(sign);
        button.setName(field().componentName(part));
        button.setToolTipText(help);
        button.getAccessibleContext().setAccessibleName(help);
        button.setEnabled(enabled);
        button.addActionListener(event -> {
            action.run();
            layOut();
            changed();
        });
        return button;
    }

    private void swap(int one, int other) {
        Collections.swap(parts, one, other);
    }

    @Override
    public final JComponent component() {
        return panel;
    }

    @Override
    public final JComponent focusTarget() {
        return parts.isEmpty() ? add : focusOf(parts.get(0));
    }

    @Override
    public final void setEditable(boolean editable) {
        this.editable = editable;
        add.setVisible(editable);
        message.setVisible(editable);
        layOut();
    }

    @Override
    protected final void refresh() {
        message.show(entry());
    }
}
