package org.sami.journal.postgres;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;

/** Writes telemetry soon after it arrives, on a daemon thread, unless a batch of entries has written it before. */
final class TelemetryFlush implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(TelemetryFlush.class.getName());
    private static final long DELAY_MILLIS = 50;

    private final Writing writing;
    private final ScheduledExecutorService thread;
    private volatile @Nullable Future<?> next;
    private final AtomicBoolean waiting = new AtomicBoolean();

    /** Writing that may fail. Its owner keeps the rows that could not be written and reports the failure when it is asked. */
    @FunctionalInterface
    interface Writing {
        void run() throws IOException;
    }

    TelemetryFlush(String name, Writing writing) {
        this.writing = writing;
        thread = Executors.newSingleThreadScheduledExecutor(work -> {
            Thread made = new Thread(work, name);
            made.setDaemon(true);
            return made;
        });
    }

    /** Telemetry has arrived. */
    void soon() {
        if (waiting.compareAndSet(false, true)) {
            try {
                next = thread.schedule(this::write, DELAY_MILLIS, TimeUnit.MILLISECONDS);
            } catch (RejectedExecutionException closed) {
                waiting.set(false); // the owner writes it when it closes
            }
        }
    }

    private void write() {
        waiting.set(false);
        try {
            writing.run();
        } catch (IOException refused) {
            LOG.log(Level.ERROR, "telemetry could not be written: {0}", refused.getMessage());
        }
    }

    @Override
    public void close() {
        Future<?> last = next;
        if (last != null) {
            last.cancel(false);
        }
        thread.shutdown();
    }
}
