package org.sami.crw.gui.decision;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.awt.event.HierarchyEvent;
import java.awt.event.MouseEvent;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;

/** Reports when the pointer goes down anywhere in a component, and when it is lifted, anywhere. Listens only while it is shown. */
final class PointerWatch implements AWTEventListener {
    private final JComponent watched;
    private final Runnable down;
    private final Runnable up;
    private boolean isDown;

    private PointerWatch(JComponent watched, Runnable down, Runnable up) {
        this.watched = watched;
        this.down = down;
        this.up = up;
    }

    static void on(JComponent watched, Runnable down, Runnable up) {
        PointerWatch watch = new PointerWatch(watched, down, up);
        watched.addHierarchyListener(event -> {
            if ((event.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0) {
                Toolkit.getDefaultToolkit().removeAWTEventListener(watch);
                if (watched.isShowing()) {
                    Toolkit.getDefaultToolkit().addAWTEventListener(watch, AWTEvent.MOUSE_EVENT_MASK);
                }
            }
        });
    }

    @Override
    public void eventDispatched(AWTEvent event) {
        if (event.getID() == MouseEvent.MOUSE_PRESSED
                && event.getSource() instanceof Component source
                && SwingUtilities.isDescendingFrom(source, watched)) {
            isDown = true;
            down.run();
        } else if (event.getID() == MouseEvent.MOUSE_RELEASED && isDown) {
            isDown = false;
            up.run();
        }
    }
}
