package org.sami.ui.check;

import java.awt.AWTKeyStroke;
import java.awt.Component;
import java.awt.Container;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import javax.accessibility.Accessible;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JInternalFrame;
import javax.swing.JList;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.JTree;
import javax.swing.plaf.basic.BasicSplitPaneDivider;
import javax.swing.text.JTextComponent;

/**
 * What of a window a person cannot reach: what has no name for a screen reader, is too small for a wet finger, or keeps the Tab key. Walks the tree of
 * components that are laid out and visible. On the event thread.
 */
public final class Reach {
    private Reach() {}

    /** What is used by a person and has no accessible name. */
    public static List<String> unnamed(Container root) {
        List<String> found = new ArrayList<>();
        walk(
                root,
                root,
                component -> isUsed(component) && accessibleName(component).isBlank(),
                found);
        return found;
    }

    private static boolean isUsed(Component component) {
        return component instanceof AbstractButton
                || component instanceof JTable
                || component instanceof JList
                || component instanceof JTree
                || component instanceof JComboBox
                || component instanceof JSlider
                || component instanceof JSpinner
                || component instanceof JTabbedPane
                || (component instanceof JTextComponent text && text.isFocusable())
                || (component.isFocusable()
                        && component.getClass().getName().startsWith("org.sami.")
                        && component instanceof JComponent own
                        && own.getInputMap(JComponent.WHEN_FOCUSED).size() > 0);
    }

    private static String accessibleName(Component component) {
        String name = component instanceof Accessible accessible
                ? accessible.getAccessibleContext().getAccessibleName()
                : null;
        return name == null ? "" : name;
    }

    /**
     * What is pressed and is lower or narrower than this.
     *
     * @param least in pixels
     */
    public static List<String> small(Container root, int least) {
        List<String> found = new ArrayList<>();
        walk(
                root,
                root,
                component -> isPressed(component)
                        && (target(component).getHeight() < least
                                || target(component).getWidth() < least)
                        && component.getWidth() > 0
                        && component.getHeight() > 0,
                found);
        return found;
    }

    /** What is pressed for it: a box that is ticked may stand in a row that takes the press for it. */
    private static Component target(Component component) {
        boolean inRow =
                component instanceof JToggleButton && component.getParent().getMouseListeners().length > 0;
        return inRow ? component.getParent() : component;
    }

    private static boolean isPressed(Component component) {
        return component instanceof AbstractButton
                || component instanceof JComboBox
                || component instanceof JSlider
                || component instanceof JTextField;
    }

    /** What takes the Tab key for itself. */
    public static List<String> keepsTab(Container root) {
        AWTKeyStroke tab = AWTKeyStroke.getAWTKeyStroke(KeyEvent.VK_TAB, 0);
        List<String> found = new ArrayList<>();
        walk(
                root,
                root,
                component -> {
                    Set<AWTKeyStroke> keys =
                            component.getFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS);
                    return component.isFocusable()
                            && isUsed(component)
                            && !(component instanceof JToggleButton) // their look has Tab lead on by itself
                            && !(component.getFocusTraversalKeysEnabled() && keys.contains(tab));
                },
                found);
        return found;
    }

    private static void walk(Container root, Container at, Predicate<Component> wrong, List<String> found) {
        for (Component child : at.getComponents()) {
            if (!child.isVisible() || child instanceof JScrollBar) {
                continue;
            }
            if (wrong.test(child)) {
                found.add(path(root, child));
            }
            if (child instanceof Container inner && !isOfSwing(child)) {
                walk(root, inner, wrong, found);
            }
        }
    }

    /** What is made of parts that are Swing's own: arrows of boxes, dividers, a file chooser's rows. */
    private static boolean isOfSwing(Component component) {
        return component instanceof JComboBox
                || component instanceof JSpinner
                || component instanceof JInternalFrame
                || component instanceof BasicSplitPaneDivider
                || component instanceof JTable
                || component instanceof JList;
    }

    private static String path(Container root, Component component) {
        StringBuilder path = new StringBuilder(words(component));
        for (Component at = component.getParent(); at != null && at != root; at = at.getParent()) {
            if (at.getName() != null
                    && !(at instanceof JSplitPane)
                    && !at.getName().startsWith("null.")) {
                path.insert(0, at.getName() + " > ");
            } else if (at instanceof JFileChooser || at instanceof JScrollPane || at instanceof JTabbedPane) {
                path.insert(0, at.getClass().getSimpleName() + " > ");
            }
        }
        return path + " (" + component.getWidth() + " x " + component.getHeight() + ")";
    }

    private static String words(Component component) {
        String text = component instanceof AbstractButton button
                ? " '" + button.getText() + "' " + button.getToolTipText()
                : "";
        return component.getClass().getSimpleName() + " " + component.getName() + text;
    }
}
