package org.sami.spn.host;

import java.util.concurrent.atomic.AtomicLong;

/** What a host has done. Safe for use by several threads. */
final class HostCounts {
    private final AtomicLong processed = new AtomicLong();
    private final AtomicLong batches = new AtomicLong();
    private final AtomicLong refused = new AtomicLong();

    /** A batch of so many inputs was processed. */
    void processed(int inputs) {
        processed.addAndGet(inputs);
        batches.incrementAndGet();
    }

    /** So many inputs were not taken in. */
    void refused(long inputs) {
        refused.addAndGet(inputs);
    }

    HostLoad load(InputQueue queue, ListenerList<HostListener> listeners) {
        return new HostLoad(
                queue.queued(),
                queue.mostQueued(),
                processed.get(),
                batches.get(),
                refused.get(),
                queue.telemetryReplaced(),
                listeners.slow(),
                listeners.faults());
    }
}
