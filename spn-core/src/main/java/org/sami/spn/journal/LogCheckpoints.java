package org.sami.spn.journal;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.file.Path;
import java.sql.SQLException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;

/**
 * Checkpoints of SQLite's write-ahead log: folds it into the file on a daemon thread, over a connection of its own, so that whoever commits does not wait for the disk (docs/decisions
 * 0641). What it cannot fold stays in the log and is folded later. May be used from any thread.
 */
final class LogCheckpoints implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(LogCheckpoints.class.getName());
    /** A disk that takes longer to fold the log is not waited for when the journal is closed. */
    private static final long PATIENCE_SECONDS = 30;

    private final Path file;
    private final int pages;
    private final ExecutorService thread;
    private final AtomicBoolean asked = new AtomicBoolean();
    private @Nullable Database own; // of the thread; closed when it has ended

    /**
     * For the log of one file; nothing is opened before it is first asked.
     *
     * @param pages from how many pages on the log is folded; 0 = never
     */
    LogCheckpoints(Path file, int pages) {
        this.file = file;
        this.pages = pages;
        this.thread = new ThreadPoolExecutor(
                1,
                1,
                0,
                TimeUnit.SECONDS,
                new LinkedBlockingQueue<>(),
                action -> {
                    Thread made = new Thread(action, "journal-checkpoint of " + file);
                    made.setDaemon(true);
                    return made;
                },
                new ThreadPoolExecutor.DiscardPolicy()); // asked after its end it does nothing
    }

    /** Looks soon whether the log is long enough to be folded. */
    void look() {
        if (pages > 0 && asked.compareAndSet(false, true)) {
            thread.execute(this::checkpointLongLog);
        }
    }

    private void checkpointLongLog() {
        asked.set(false);
        try {
            Database database = own;
            if (database == null) {
                database = Database.open(file);
                own = database;
            }
            if (database.pagesInLog() >= pages) {
                database.checkpointPassive();
            }
        } catch (IOException | SQLException refused) {
            LOG.log(Level.DEBUG, "the log of {0} cannot be folded now: {1}", file, refused.getMessage());
        }
    }

    /** Waits until it folds no longer. */
    @Override
    public void close() throws IOException {
        thread.shutdown();
        try {
            if (thread.awaitTermination(PATIENCE_SECONDS, TimeUnit.SECONDS) && own != null) {
                own.close();
            }
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
    }
}
