package org.sami.crw.gui.mission;

import java.awt.Dimension;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import javax.swing.text.Document;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

/** The field in which plans are searched: Down and Enter lead to what was found, Escape empties it. On the event thread. */
final class PlanSearchField extends JTextField {
    private static final int NARROW = 88;
    private static final int WIDE = 220;
    private static final int BUTTONS = 400; // this width is first given to what is next to it

    /**
     * A field over a text that other fields may show as well.
     *
     * @param found brings the focus to what was found
     */
    PlanSearchField(String name, Document text, Runnable found) {
        super(text, null, 0);
        setName(name);
        putClientProperty("JTextField.placeholderText", "Search plans");
        putClientProperty("JTextField.showClearButton", true);
        getAccessibleContext().setAccessibleName("Search plans");
        bind("DOWN", found);
        bind("ENTER", found);
        bind("ESCAPE", () -> setText(""));
    }

    /** Has something done after each change of a text. */
    static void onChange(Document text, Runnable changed) {
        text.addDocumentListener(new DocumentListener() {
            @Override
            public void insertUpdate(DocumentEvent e) {
                changed.run();
            }

            @Override
            public void removeUpdate(DocumentEvent e) {
                changed.run();
            }

            @Override
            public void changedUpdate(DocumentEvent e) {
                changed.run();
            }
        });
    }

    @Override
    public Dimension getPreferredSize() {
        int room = getParent() == null ? 0 : getParent().getWidth() - Look.px(BUTTONS);
        int width = Math.max(Look.px(NARROW), Math.min(Look.px(WIDE), room));
        return new Dimension(width, Math.max(super.getPreferredSize().height, Look.px(Spacing.HIT_TARGET_FIELD)));
    }

    private void bind(String key, Runnable action) {
        getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke(key), key);
        getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(java.awt.event.ActionEvent e) {
                action.run();
            }
        });
    }
}
