package org.sami.ui.dock;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Container;
import java.awt.Point;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.awt.event.MouseEvent;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.LongSupplier;
import javax.swing.JList;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import javax.swing.ToolTipManager;
import javax.swing.text.JTextComponent;

/** Whether the hand with the pointer rests: what lies under it then may move (docs/windows.md). On the event thread. */
final class PointerRest implements AWTEventListener, AutoCloseable {
    private static final long RETURN_NANOS = 1_000_000_000L;
    private static final long SHRINK_NANOS = 5_000_000_000L; // a pointer that has just stopped may press

    private final LongSupplier nanos;
    private final Function<Container, Optional<Point>> position;
    private boolean used;
    private boolean down;
    private long usedNanos;

    /**
     * What can be pressed under the pointer.
     *
     * @param at where it lies in the container that was asked about, in pixels
     */
    record Pressable(Component what, Point at) {}

    /**
     * A pointer that has not been used yet.
     *
     * @param nanos the time, in nanoseconds from any origin
     * @param position where the pointer is in a container, in pixels; empty where it is elsewhere
     */
    PointerRest(LongSupplier nanos, Function<Container, Optional<Point>> position) {
        this.nanos = nanos;
        this.position = position;
    }

    /** Watches the pointer of the screen from now on. */
    static PointerRest watch() {
        PointerRest pointer =
                new PointerRest(System::nanoTime, container -> Optional.ofNullable(container.getMousePosition(true)));
        Toolkit.getDefaultToolkit()
                .addAWTEventListener(pointer, AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_MOTION_EVENT_MASK);
        return pointer;
    }

    @Override
    public void eventDispatched(AWTEvent event) {
        if (event instanceof MouseEvent mouse
                && mouse.getID() != MouseEvent.MOUSE_ENTERED
                && mouse.getID() != MouseEvent.MOUSE_EXITED) {
            used = true;
            usedNanos = nanos.getAsLong();
            down = mouse.getID() == MouseEvent.MOUSE_PRESSED
                    || mouse.getID() == MouseEvent.MOUSE_DRAGGED
                    || (down && mouse.getID() != MouseEvent.MOUSE_RELEASED);
        }
    }

    /** Whether what is in a container may move because something has gone: no button is down, and the pointer is elsewhere or has rested for five seconds. */
    boolean letsShrink(Container container) {
        return letsMove(container, SHRINK_NANOS);
    }

    /** Whether what is in a container may move because something has come: no button is down, and the pointer is elsewhere or has rested for a second. */
    boolean letsReturn(Container container) {
        return letsMove(container, RETURN_NANOS);
    }

    private boolean letsMove(Container container, long rest) {
        return !down
                && (!used
                        || nanos.getAsLong() - usedNanos > rest
                        || position.apply(container).isEmpty());
    }

    /** What can be pressed under the pointer in a container: a button, a row, a tab, a field, anything that listens to the mouse. */
    Optional<Pressable> pressable(Container container) {
        return position.apply(container).flatMap(at -> {
            Component target = SwingUtilities.getDeepestComponentAt(container, at.x, at.y);
            while (target != null && target != container && !listens(target)) {
                target = target.getParent();
            }
            return target == null
                            || target == container
                            || !takesPress(target, SwingUtilities.convertPoint(container, at, target))
                    ? Optional.empty()
                    : Optional.of(new Pressable(target, SwingUtilities.convertPoint(target, new Point(), container)));
        });
    }

    private static boolean listens(Component component) {
        return !(component instanceof JSplitPane) // its divider listens to it, and takes what is pressed on itself only
                && Arrays.stream(component.getMouseListeners()).anyMatch(one -> !(one instanceof ToolTipManager));
    }

    /** Tables, lists, tabs and texts listen everywhere, and do nothing where there is nothing in them. */
    private static boolean takesPress(Component component, Point at) {
        if (component instanceof JTable table) {
            return table.rowAtPoint(at) >= 0;
        }
        if (component instanceof JList<?> list) {
            int row = list.locationToIndex(at);
            return row >= 0 && list.getCellBounds(row, row).contains(at);
        }
        if (component instanceof JTabbedPane tabs) {
            return tabs.indexAtLocation(at.x, at.y) >= 0;
        }
        return !(component instanceof JTextComponent text) || text.isFocusable();
    }

    @Override
    public void close() {
        Toolkit.getDefaultToolkit().removeAWTEventListener(this);
    }
}
