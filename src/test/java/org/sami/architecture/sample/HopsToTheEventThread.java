package org.sami.architecture.sample;

import javax.swing.SwingUtilities;

/** Hands work to the event thread by itself. */
public final class HopsToTheEventThread {
    /** Runs it there. */
    public void run(Runnable work) {
        SwingUtilities.invokeLater(work);
    }
}
