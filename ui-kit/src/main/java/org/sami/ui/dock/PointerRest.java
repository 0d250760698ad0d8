package org.sami.ui.dock;

import java.awt.AWTEvent;
import java.awt.Container;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.awt.event.MouseEvent;

/** Whether the hand with the pointer rests: what lies under it then may move. On the event thread. */
final class PointerRest implements AWTEventListener, AutoCloseable {
    private static final long REST_NANOS = 1_000_000_000L;

    private boolean used;
    private boolean down;
    private long usedNanos;

    /** Watches the pointer from now on. */
    PointerRest() {
        Toolkit.getDefaultToolkit()
                .addAWTEventListener(this, AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_MOTION_EVENT_MASK);
    }

    @Override
    public void eventDispatched(AWTEvent event) {
        if (event instanceof MouseEvent mouse
                && mouse.getID() != MouseEvent.MOUSE_ENTERED
                && mouse.getID() != MouseEvent.MOUSE_EXITED) {
            used = true;
            usedNanos = System.nanoTime();
            down = mouse.getID() == MouseEvent.MOUSE_PRESSED
                    || mouse.getID() == MouseEvent.MOUSE_DRAGGED
                    || (down && mouse.getID() != MouseEvent.MOUSE_RELEASED);
        }
    }

    /** Whether no button is down, and the pointer is not over a container, or was not used yet. */
    boolean isAwayFrom(Container container) {
        return !down && (!used || container.getMousePosition(true) == null);
    }

    /** Whether no button is down, and the pointer is elsewhere, or neither moves nor presses for a second. */
    boolean letsMove(Container container) {
        return isAwayFrom(container) || (!down && System.nanoTime() - usedNanos > REST_NANOS);
    }

    @Override
    public void close() {
        Toolkit.getDefaultToolkit().removeAWTEventListener(this);
    }
}
