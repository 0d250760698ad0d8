package org.sami.crw.gui.decision;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.sami.ui.command.OnePress;

/** The keys of the panel while the focus is in it: digits choose, Enter answers, Escape puts the pen down or leaves. In a text, digits are text. */
final class DecisionKeys {
    private static final int DIGITS = 9;

    private DecisionKeys() {}

    static void bind(JComponent panel, DecisionSteps steps) {
        for (int i = 0; i < DIGITS; i++) {
            int option = i;
            Runnable choose = () -> {
                if (!(focusOwner() instanceof JTextComponent)) {
                    steps.choose(option);
                }
            };
            bind(panel, KeyEvent.VK_1 + i, "choose-" + (i + 1), choose);
            bind(panel, KeyEvent.VK_NUMPAD1 + i, "choose-" + (i + 1), choose);
        }
        OnePress enter = new OnePress(); // the next decision is shown by the second
        bind(panel, KeyEvent.VK_ENTER, "answer", () -> {
            if (enter.isOwn()) {
                steps.answer();
            }
        });
        bind(panel, KeyEvent.VK_ESCAPE, "leave", steps::escape);
    }

    private static void bind(JComponent panel, int key, String name, Runnable action) {
        panel.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke(key, 0), name);
        panel.getActionMap().put(name, new AbstractAction(name) {
            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }

    /** Whether the keyboard's focus is somewhere in a component. */
    static boolean hasFocusIn(JComponent component) {
        Component owner = focusOwner();
        return owner != null && SwingUtilities.isDescendingFrom(owner, component);
    }

    private static Component focusOwner() {
        return KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    }
}
