package org.sami.journal.postgres;

import java.sql.Connection;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;

/**
 * Ends a writing that is not answered by the time the lease of its base is over: it fails then, and its base stops commanding, long before an answer is given up. A writing that takes long
 * while the lease is renewed goes on. By a daemon thread of its own.
 */
final class LateWriting implements AutoCloseable {
    private static final long LOOK_MILLIS = 100;

    private final Lease lease;
    private final AtomicReference<@Nullable Connection> underWay = new AtomicReference<>();
    private final ScheduledExecutorService thread;

    /**
     * Looks from now on.
     *
     * @param name of its thread
     */
    LateWriting(String name, Lease lease) {
        this.lease = lease;
        thread = Executors.newSingleThreadScheduledExecutor(work -> {
            Thread made = new Thread(work, name);
            made.setDaemon(true);
            return made;
        });
        var unused = thread.scheduleWithFixedDelay(this::look, LOOK_MILLIS, LOOK_MILLIS, TimeUnit.MILLISECONDS);
    }

    /** A writing begins, of which the lease was held just now. */
    void begins(Connection by) {
        underWay.set(by);
    }

    /** The writing that began last is over, well or not. */
    void isOver() {
        underWay.set(null);
    }

    private void look() {
        Connection by = underWay.get();
        if (by != null && lease.lost().isPresent() && underWay.compareAndSet(by, null)) {
            Connections.drop(by);
        }
    }

    @Override
    public void close() {
        thread.shutdownNow();
    }
}
