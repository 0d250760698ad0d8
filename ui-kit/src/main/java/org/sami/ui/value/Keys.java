package org.sami.ui.value;

import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** Keys of a component. */
final class Keys {
    private Keys() {}

    /** Runs an action when a key is pressed while the component has the focus. */
    static void bind(JComponent component, int key, int modifiers, String name, Runnable action) {
        component.getInputMap().put(KeyStroke.getKeyStroke(key, modifiers), name);
        component.getActionMap().put(name, new AbstractAction(name) {
            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }
}
