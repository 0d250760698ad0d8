package org.sami.ui.dock;

import java.awt.Component;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.JTabbedPane;
import javax.swing.KeyStroke;

/**
 * Leaves Alt with the left and right arrow to the window's commands: Modern Docking would turn to the next tab instead. Tabs are turned by Ctrl+Page Up and
 * Page Down, as everywhere in Swing. On the event thread.
 */
final class TabKeys {
    private static final int ALT = InputEvent.ALT_DOWN_MASK;
    private static final int ALT_GRAPH = ALT | InputEvent.ALT_GRAPH_DOWN_MASK;

    private TabKeys() {}

    /** Takes the keys from all tabbed panes below a component, and from those that are added to it later. */
    static void leaveToCommands(Component component) {
        ComponentWatch.on(component, found -> {
            if (found instanceof JTabbedPane tabs) {
                InputMap keys = tabs.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT);
                for (int key : new int[] {KeyEvent.VK_LEFT, KeyEvent.VK_RIGHT}) {
                    keys.remove(KeyStroke.getKeyStroke(key, ALT));
                    keys.remove(KeyStroke.getKeyStroke(key, ALT_GRAPH));
                }
            }
        });
    }
}
