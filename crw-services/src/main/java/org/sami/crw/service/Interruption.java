package org.sami.crw.service;

import java.util.concurrent.CancellationException;

/** How services end early: whoever runs one interrupts its thread, and its long loops ask here. */
public final class Interruption {
    private Interruption() {}

    /**
     * Looks whether the service is to end.
     *
     * @throws CancellationException if its thread was interrupted; it stays so
     */
    public static void check() {
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("given up before it was done");
        }
    }
}
