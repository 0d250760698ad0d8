package org.sami.dreamm.inspector;

import java.awt.Component;
import java.awt.Container;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import javax.swing.JScrollPane;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;

/**
 * What the author works at in a scrolled column: it stays where it is in the view while the rows around it are made again. Components are
 * known again by the names that lead to them.
 */
final class ScrollAnchor {
    private static final int PASSES = 4; // a text that wraps says its height only after it has a width

    private final JScrollPane scrolled;
    private final Point position;
    private final List<String> names;
    private final int fromTop;
    private final boolean focused;

    private ScrollAnchor(JScrollPane scrolled, Optional<Component> at, boolean focused) {
        JViewport viewport = scrolled.getViewport();
        this.scrolled = scrolled;
        this.position = viewport.getViewPosition();
        this.names = at.map(component -> names(component, viewport.getView())).orElse(List.of());
        this.fromTop =
                at.map(component -> top(component, viewport) - position.y).orElse(0);
        this.focused = focused;
    }

    /** Remembers the component that has the focus, or else the first one in the view. */
    static ScrollAnchor of(JScrollPane scrolled) {
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getPermanentFocusOwner();
        Container column = (Container) scrolled.getViewport().getView();
        if (owner != null && owner.getName() != null && SwingUtilities.isDescendingFrom(owner, column)) {
            return new ScrollAnchor(scrolled, Optional.of(owner), true);
        }
        return new ScrollAnchor(scrolled, firstSeen(column, scrolled.getViewport()), false);
    }

    private static Optional<Component> firstSeen(Container container, JViewport viewport) {
        Rectangle seen = viewport.getViewRect();
        for (Component child : container.getComponents()) {
            int top = top(child, viewport);
            if (!child.isVisible() || top + child.getHeight() <= seen.y || top >= seen.y + seen.height) {
                continue;
            }
            if (child.getName() != null && top >= seen.y) {
                return Optional.of(child);
            }
            Optional<Component> inner =
                    child instanceof Container parent ? firstSeen(parent, viewport) : Optional.empty();
            if (inner.isPresent()) {
                return inner;
            }
        }
        return Optional.empty();
    }

    private static int top(Component component, JViewport viewport) {
        return SwingUtilities.convertPoint(component, 0, 0, viewport.getView()).y;
    }

    private static List<String> names(Component component, Component column) {
        Deque<String> names = new ArrayDeque<>();
        for (Component at = component; at != null && at != column; at = at.getParent()) {
            if (at.getName() != null) {
                names.addFirst(at.getName());
            }
        }
        return List.copyOf(names);
    }

    /** Lays the column out, brings the component back to where it was, and gives it the focus again if it had it. */
    void restore() {
        for (int i = 0; i < PASSES && !scrolled.isValid(); i++) {
            scrolled.validate();
        }
        JViewport viewport = scrolled.getViewport();
        Optional<Component> there = find((Container) viewport.getView(), names);
        there.ifPresentOrElse(component -> scrollTo(top(component, viewport) - fromTop), () -> scrollTo(position.y));
        if (focused) {
            there.ifPresent(this::focus);
        }
    }

    private void scrollTo(int y) {
        JViewport viewport = scrolled.getViewport();
        int last = viewport.getView().getHeight() - viewport.getExtentSize().height;
        viewport.setViewPosition(new Point(0, Math.max(0, Math.min(y, last))));
    }

    /** What an edit has put below a choice, such as the editor of a value, is brought into the view as well. */
    private void focus(Component component) {
        component.requestFocusInWindow();
        Container row = SwingUtilities.getAncestorOfClass(Form.class, component);
        if (row instanceof Form form
                && form.getHeight() <= scrolled.getViewport().getHeight()) {
            form.scrollRectToVisible(new Rectangle(form.getSize()));
        }
    }

    private static Optional<Component> find(Container root, List<String> names) {
        if (names.isEmpty()) {
            return Optional.empty();
        }
        for (Component child : root.getComponents()) {
            boolean named = names.get(0).equals(child.getName());
            if (named && names.size() == 1) {
                return Optional.of(child);
            }
            List<String> rest = named ? names.subList(1, names.size()) : names;
            Optional<Component> found = child instanceof Container inner && (named || child.getName() == null)
                    ? find(inner, rest)
                    : Optional.empty();
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.empty();
    }
}
