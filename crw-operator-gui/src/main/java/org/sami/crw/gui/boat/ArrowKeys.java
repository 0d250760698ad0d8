package org.sami.crw.gui.boat;

import java.awt.Component;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.beans.PropertyChangeEvent;
import java.beans.PropertyChangeListener;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import javax.swing.JRootPane;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;

/**
 * The arrow keys that are held to drive a boat, and Escape that ends it. A key counts in the window that has the keyboard, by itself and outside of texts: with another key
 * held it is a command's. Once that window has lost the keyboard none is held, as the release of a key is told to another window. On the event thread.
 */
final class ArrowKeys {
    private static final String FOCUSED_WINDOW = "focusedWindow";
    private static final int OTHERS = InputEvent.SHIFT_DOWN_MASK
            | InputEvent.CTRL_DOWN_MASK
            | InputEvent.ALT_DOWN_MASK
            | InputEvent.ALT_GRAPH_DOWN_MASK
            | InputEvent.META_DOWN_MASK;
    private static final Set<Integer> KEYS =
            Set.of(KeyEvent.VK_UP, KeyEvent.VK_DOWN, KeyEvent.VK_LEFT, KeyEvent.VK_RIGHT);

    private final Set<Integer> held = new HashSet<>();
    private final KeyEventDispatcher keys = this::take;
    private final PropertyChangeListener windows = this::windowChanged;
    private final Runnable escape;
    private final Runnable keyboardLost;
    private Optional<Window> own = Optional.empty();

    /**
     * Takes no keys yet.
     *
     * @param escape runs when Escape is pressed
     * @param keyboardLost runs when the window has lost the keyboard
     */
    ArrowKeys(Runnable escape, Runnable keyboardLost) {
        this.escape = escape;
        this.keyboardLost = keyboardLost;
    }

    /** Takes them from now on, in the window that has the keyboard; a text there no longer has the focus. */
    void start() {
        held.clear();
        KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        own = Optional.ofNullable(manager.getFocusedWindow());
        leaveText(manager.getFocusOwner());
        manager.addKeyEventDispatcher(keys);
        manager.addPropertyChangeListener(FOCUSED_WINDOW, windows);
    }

    private static void leaveText(Component focused) {
        if (focused instanceof JTextComponent) {
            JRootPane root = SwingUtilities.getRootPane(focused);
            root.requestFocusInWindow();
        }
    }

    /** Takes none any longer. */
    void stop() {
        KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        manager.removeKeyEventDispatcher(keys);
        manager.removePropertyChangeListener(FOCUSED_WINDOW, windows);
        held.clear();
    }

    /** 1 where the one key is held, -1 where the other is, 0 where neither or both are. */
    int axis(int plus, int minus) {
        return (held.contains(plus) ? 1 : 0) - (held.contains(minus) ? 1 : 0);
    }

    private void windowChanged(PropertyChangeEvent change) {
        if (change.getOldValue() != null) {
            held.clear();
            keyboardLost.run();
        } else if (own.isEmpty()) {
            own = Optional.ofNullable((Window) change.getNewValue());
        }
    }

    private boolean take(KeyEvent event) {
        int key = event.getKeyCode();
        if (event.getID() == KeyEvent.KEY_RELEASED) {
            return held.remove(key);
        }
        if (event.getID() != KeyEvent.KEY_PRESSED || !isOfOwnWindow(event.getComponent())) {
            return false;
        }
        boolean alone = (event.getModifiersEx() & OTHERS) == 0;
        if (key == KeyEvent.VK_ESCAPE && alone) {
            escape.run();
            return true;
        }
        if (!KEYS.contains(key) || !alone || isText(event.getComponent())) {
            held.remove(key); // pressed anew it means something else
            return false;
        }
        held.add(key);
        return true;
    }

    private boolean isOfOwnWindow(Component component) {
        return own.isEmpty() || own.get() == windowOf(component);
    }

    private static Window windowOf(Component component) {
        return component instanceof Window window ? window : SwingUtilities.getWindowAncestor(component);
    }

    private static boolean isText(Component component) {
        return component instanceof JTextComponent text && text.isEditable();
    }
}
