package org.sami.ui.sheet;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.beans.PropertyChangeListener;
import java.util.Objects;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLayeredPane;
import javax.swing.JRootPane;
import javax.swing.LayoutFocusTraversalPolicy;
import javax.swing.SwingUtilities;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

/**
 * Shows one thing at a time over a window's panels, inside the window. Nothing waits for it: panels, commands and keys go on working. It leaves
 * free what must stay in sight, such as the strip with the fleet stop. Escape closes it, and the focus goes back to where it was, or to
 * no button where that is out of sight. On the event thread.
 */
public final class WindowSheet {
    private static final LayoutFocusTraversalPolicy FIRST_IN = new LayoutFocusTraversalPolicy();

    private static final int PASSES = 2; // a text that wraps says its height only after it has a width

    private final JRootPane root;
    private final Runnable placing = this::place;
    private final PropertyChangeListener focusWatch = change ->
            focusMoved(KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner());
    private Optional<JComponent> keptFree = Optional.empty();
    private Optional<Shown> shown = Optional.empty();

    /** What is shown, over what, and who had the focus before. */
    private record Shown(SheetPanel panel, Sheet sheet, Optional<Component> focusedBefore) {}

    private WindowSheet(JRootPane root) {
        this.root = root;
        root.getLayeredPane().addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent resized) {
                place();
            }
        });
    }

    /**
     * The sheet of the window in which a component lies.
     *
     * @throws IllegalArgumentException if it lies in no window
     */
    public static WindowSheet in(Component inside) {
        JRootPane root = SwingUtilities.getRootPane(inside);
        if (root == null) {
            throw new IllegalArgumentException("the component " + inside.getName() + " lies in no window");
        }
        return find(root).orElseGet(() -> {
            WindowSheet made = new WindowSheet(root);
            root.putClientProperty(WindowSheet.class, made);
            return made;
        });
    }

    /** The sheet of a component's window, where it was asked for before ({@link #in}); else empty. */
    public static Optional<WindowSheet> find(Component inside) {
        return Optional.ofNullable(SwingUtilities.getRootPane(inside))
                .map(root -> (WindowSheet) root.getClientProperty(WindowSheet.class));
    }

    /** Leaves a strip at the window's top free, at all sizes. */
    public void keepFree(JComponent strip) {
        keptFree = Optional.of(strip);
        place();
    }

    /** Shows something, in place of what was shown before. The focus goes to the first thing in it. */
    public void open(Sheet sheet) {
        Objects.requireNonNull(sheet, "sheet");
        Optional<Component> before = Optional.ofNullable(
                        KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner())
                .filter(owner -> SwingUtilities.getRootPane(owner) == root && !(owner instanceof Window));
        Optional<Component> inSheetBefore = shown.flatMap(Shown::focusedBefore);
        remove(false);
        SheetPanel panel = new SheetPanel(sheet, this::close);
        shown = Optional.of(
                new Shown(panel, sheet, before.filter(Component::isShowing).or(() -> inSheetBefore)));
        root.getLayeredPane().add(panel, JLayeredPane.PALETTE_LAYER);
        Look.addListener(placing);
        place();
        Component first = FIRST_IN.getDefaultComponent(sheet.content());
        Optional.ofNullable(first).ifPresent(Component::requestFocusInWindow);
        if (sheet.passing()) {
            KeyboardFocusManager.getCurrentKeyboardFocusManager()
                    .addPropertyChangeListener("permanentFocusOwner", focusWatch);
        }
    }

    /** Gives what is shown the room that it wants now; to be called after it has changed its size. */
    public void fit() {
        place();
    }

    /** Whether something is shown. */
    public boolean isOpen() {
        return shown.isPresent();
    }

    /** The name of what is shown; empty text where nothing is. */
    public String name() {
        return shown.map(now -> now.sheet().name()).orElse("");
    }

    /** Closes what is shown. */
    public void close() {
        remove(true);
    }

    private void remove(boolean giveFocusBack) {
        shown.ifPresent(now -> {
            Component focused =
                    KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
            boolean hadFocus = focused != null && SwingUtilities.isDescendingFrom(focused, now.panel());
            KeyboardFocusManager.getCurrentKeyboardFocusManager()
                    .removePropertyChangeListener("permanentFocusOwner", focusWatch);
            Look.removeListener(placing);
            shown = Optional.empty();
            root.getLayeredPane().remove(now.panel());
            root.getLayeredPane().repaint(now.panel().getBounds());
            if (giveFocusBack && hadFocus) {
                now.focusedBefore()
                        .filter(Component::isShowing)
                        .orElse(root) // else it goes to the window's first button, such as one that stops the fleet
                        .requestFocusInWindow();
            }
            now.sheet().closed().run();
        });
    }

    private void focusMoved(Component owner) {
        boolean left = shown.map(now -> owner != null && !SwingUtilities.isDescendingFrom(owner, now.panel()))
                .orElse(false);
        if (left) {
            remove(false);
        }
    }

    /** As large as it wants to be and the room allows, over the middle of what it belongs to. */
    private void place() {
        shown.ifPresent(now -> {
            Rectangle room = room();
            int width = Math.min(now.panel().getPreferredSize().width, room.width);
            for (int i = 0; i < PASSES; i++) {
                now.panel().setSize(width, now.panel().getPreferredSize().height);
                now.panel().validate();
            }
            int height = Math.min(now.panel().getPreferredSize().height, room.height);
            Point middle = now.sheet()
                    .over()
                    .filter(Component::isShowing)
                    .map(this::middleOf)
                    .orElse(new Point((int) room.getCenterX(), room.y + height / 2));
            int x = Math.max(room.x, Math.min(middle.x - width / 2, room.x + room.width - width));
            int y = Math.max(room.y, Math.min(middle.y - height / 2, room.y + room.height - height));
            now.panel().setBounds(x, y, width, height);
            now.panel().revalidate();
        });
    }

    private Point middleOf(Component over) {
        Rectangle bounds = SwingUtilities.convertRectangle(over.getParent(), over.getBounds(), root.getLayeredPane());
        return new Point((int) bounds.getCenterX(), (int) bounds.getCenterY());
    }

    /** The content of the window below what is kept free. */
    private Rectangle room() {
        Rectangle room = SwingUtilities.convertRectangle(
                root.getContentPane().getParent(), root.getContentPane().getBounds(), root.getLayeredPane());
        int top = keptFree.filter(Component::isShowing)
                .map(strip -> SwingUtilities.convertPoint(strip, 0, strip.getHeight(), root.getLayeredPane()).y)
                .orElse(room.y);
        int margin = Look.px(Spacing.NORMAL);
        int least = Math.max(room.y, top) + margin;
        return new Rectangle(
                room.x + margin,
                least,
                Math.max(0, room.width - 2 * margin),
                Math.max(0, room.y + room.height - least - margin));
    }
}
