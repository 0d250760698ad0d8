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

/** Has telemetry written soon after it came, on a daemon thread of its own, where no batch takes it along before. */
final class TelemetryFlush implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(TelemetryFlush.class.getName());
    private static final long DELAY_MILLIS = 50;

    private final Writing writing;
    private final ScheduledExecutorService thread;
    private volatile @Nullable Future<?> next;
    private final AtomicBoolean waiting = new AtomicBoolean();

    /** Work that may fail; its owner keeps what could not be written, and says so when it is asked. */
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

    /** Something came. */
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
