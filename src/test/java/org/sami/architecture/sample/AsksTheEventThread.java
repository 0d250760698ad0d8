package org.sami.architecture.sample;

import javax.swing.SwingUtilities;

/** Asks by itself on which thread it is. */
public final class AsksTheEventThread {
    /** Whether this is the event thread. */
    public boolean isHere() {
        return SwingUtilities.isEventDispatchThread();
    }
}
