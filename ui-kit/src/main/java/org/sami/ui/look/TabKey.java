package org.sami.ui.look;

import java.awt.KeyboardFocusManager;
import java.util.Map;
import javax.swing.JComponent;

/** Has the Tab key lead on from tables and texts of several lines, which else keep it for their cells and for tabs. On the event thread. */
public final class TabKey {
    private static final Map<String, Integer> DIRECTIONS = Map.of(
            "forwardFocusTraversalKeys", KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS,
            "backwardFocusTraversalKeys", KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS);

    private TabKey() {}

    /** Tab and Shift+Tab leave a component from now on, in any look: looks set keys of their own again. */
    public static void leaves(JComponent component) {
        DIRECTIONS.forEach((property, direction) -> {
            component.setFocusTraversalKeys(direction, null); // those of what it lies in
            component.addPropertyChangeListener(property, changed -> {
                if (component.areFocusTraversalKeysSet(direction)) {
                    component.setFocusTraversalKeys(direction, null);
                }
            });
        });
    }
}
