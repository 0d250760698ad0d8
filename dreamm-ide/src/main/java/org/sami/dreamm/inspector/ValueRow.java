package org.sami.dreamm.inspector;

import java.awt.BorderLayout;
import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.beans.PropertyChangeListener;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.sami.spn.value.Value;
import org.sami.ui.value.ValueEditor;

/** The editor of one value, which is given when the focus leaves the editor or Enter is pressed in it, if it is a value then. */
final class ValueRow extends JPanel {
    private final transient ValueEditor editor;
    private final transient Consumer<Value> given;
    private final transient PropertyChangeListener focus = change -> left(change.getOldValue(), change.getNewValue());
    private transient Optional<Value> value;

    /**
     * An editor.
     *
     * @param value what it shows first
     * @param given receives the new value
     */
    ValueRow(ValueEditor editor, Optional<Value> value, Consumer<Value> given) {
        super(new BorderLayout());
        this.editor = Objects.requireNonNull(editor, "editor");
        this.value = Objects.requireNonNull(value, "value");
        this.given = Objects.requireNonNull(given, "given");
        setOpaque(false);
        value.ifPresentOrElse(editor::show, editor::clear);
        add(editor.component());
        putClientProperty(Pending.KEY, (Runnable) this::give);
        getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                .put(KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0), "give");
        getActionMap().put("give", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                give();
            }
        });
    }

    /** Gives what the editor holds, where the author has changed it and it is a value. */
    void give() {
        Optional<Value> now = editor.entry().value();
        if (editor.isTouched() && now.isPresent() && !now.equals(value)) {
            value = now;
            given.accept(now.get());
        }
    }

    ValueEditor editor() {
        return editor;
    }

    private void left(Object from, Object to) {
        boolean wasIn = from instanceof java.awt.Component c && SwingUtilities.isDescendingFrom(c, this);
        boolean isIn = to instanceof java.awt.Component c && SwingUtilities.isDescendingFrom(c, this);
        if (wasIn && !isIn) {
            give();
        }
    }

    @Override
    public void addNotify() {
        super.addNotify();
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addPropertyChangeListener("permanentFocusOwner", focus);
    }

    @Override
    public void removeNotify() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager()
                .removePropertyChangeListener("permanentFocusOwner", focus);
        super.removeNotify();
    }
}
