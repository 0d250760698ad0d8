package org.sami.architecture.sample;

import java.awt.EventQueue;

/** Hands work to the queue of events by itself. */
public final class QueuesAnEvent {
    /** Runs it there. */
    public void run(Runnable work) {
        EventQueue.invokeLater(work);
    }
}
