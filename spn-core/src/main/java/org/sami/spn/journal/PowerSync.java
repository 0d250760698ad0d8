package org.sami.spn.journal;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;

/**
 * Makes what SQLite has written to the write-ahead log survive the loss of power: at once, or within a delay on its own
 * daemon thread. It forces the log through a handle of its own; SQLite's locks are on other files and not touched by it.
 */
final class PowerSync implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(PowerSync.class.getName());

    private final Path log;
    private final int delayMillis;
    private final Before before;
    private final Runnable after;
    private final ScheduledThreadPoolExecutor timer;
    private final AtomicBoolean waiting = new AtomicBoolean();
    private @Nullable FileChannel channel;
    private volatile boolean closed;
    private volatile @Nullable Future<?> scheduled;
    private volatile @Nullable IOException fault;

    /**
     * For one log.
     *
     * @param withinMillis an upper limit; half of it is waited. 0 = nothing happens by itself
     * @param before done on the sync's thread before the log is forced by itself
     * @param after done on the sync's thread after that; must be quick
     */
    PowerSync(Path log, int withinMillis, Before before, Runnable after) {
        this.log = log;
        this.before = before;
        this.after = after;
        this.delayMillis = withinMillis / 2;
        this.timer = new ScheduledThreadPoolExecutor(1, action -> {
            Thread thread = new Thread(action, "journal-sync of " + log);
            thread.setDaemon(true);
            return thread;
        });
        timer.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    }

    /** Something was written: it will be forced soon. */
    void soon() throws IOException {
        if (fault != null) {
            throw new IOException("the disk refused earlier data: " + fault.getMessage(), fault);
        }
        if (!closed && delayMillis > 0 && waiting.compareAndSet(false, true)) {
            scheduled = timer.schedule(this::later, delayMillis, TimeUnit.MILLISECONDS);
        }
    }

    /** Whether the disk refused what was written. */
    boolean hasFailed() {
        return fault != null;
    }

    /** What was refused has been written again, and is on the disk. */
    void recovered() {
        fault = null;
    }

    private void later() {
        waiting.set(false);
        try {
            before.run();
        } catch (IOException refused) {
            LOG.log(
                    Level.ERROR,
                    "telemetry could not be written",
                    refused); // the journal keeps it, and says so when it is asked
            return;
        }
        try {
            now();
        } catch (IOException refused) {
            fault = refused;
            LOG.log(Level.ERROR, "the journal's log " + log + " could not be forced to disk", refused);
            return;
        }
        after.run();
    }

    /** Forces what was written until now; does nothing where there is no log. */
    synchronized void now() throws IOException {
        if (closed) {
            return;
        }
        if (channel == null) {
            if (!Files.exists(log)) {
                return;
            }
            channel = FileChannel.open(log, StandardOpenOption.WRITE);
            forceName();
        }
        channel.force(false);
    }

    /** The log's name in its folder; some systems have no handles of folders, and keep names by themselves. */
    private void forceName() {
        Optional<Path> folder = Optional.ofNullable(log.toAbsolutePath().getParent());
        folder.ifPresent(path -> {
            try (FileChannel names = FileChannel.open(path, StandardOpenOption.READ)) {
                names.force(true);
            } catch (IOException unsupported) {
                LOG.log(Level.DEBUG, "the folder {0} cannot be forced: {1}", path, unsupported.getMessage());
            }
        });
    }

    @Override
    public void close() throws IOException {
        if (scheduled != null) {
            scheduled.cancel(false);
        }
        timer.shutdownNow();
        synchronized (this) {
            closed = true;
            if (channel != null) {
                channel.close();
            }
        }
    }

    /** Work that may fail. */
    @FunctionalInterface
    interface Before {
        void run() throws IOException;
    }
}
