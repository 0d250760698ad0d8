package org.sami.crw.session.fault;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.crw.operator.HealthModel;
import org.sami.crw.operator.health.HealthKind;
import org.sami.spn.journal.SqliteJournal;
import org.sami.spn.journal.StoredJournal;

/** Looks at memory, disk and the journal's database on a daemon thread of its own, which may hang with the disk: nothing else waits for it. It looks at the database also while the engine waits for that. */
public final class SystemWatch implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(SystemWatch.class.getName());
    private static final String NAME = "system-watch";
    private static final int DISK_EVERY = 5;

    /** Short against the seconds until missions stand still. */
    private static final long DATABASE_EVERY_MS = 250;

    private final HealthModel health;
    private final ThreadGuard guard;
    private final Optional<JournalWatch> journal;
    private final Optional<DatabaseWatch> database;
    private final MemoryWatch memory = new MemoryWatch();
    private final ScheduledExecutorService thread;
    private final AtomicBoolean looking = new AtomicBoolean();
    private long looks; // for the thread

    /**
     * Watches from now on: a database by itself, the rest at each call of {@link #look}.
     *
     * @param journal the journal whose file and disk it watches, or else its database; empty for none
     * @param guard receives exceptions of this watch
     */
    public SystemWatch(Optional<StoredJournal> journal, HealthModel health, ThreadGuard guard) {
        this.health = health;
        this.guard = guard;
        this.journal =
                journal.flatMap(one -> one instanceof SqliteJournal file ? watch(file, health) : Optional.empty());
        database = journal.filter(one -> one.inFile().isEmpty()).map(one -> new DatabaseWatch(one::warning));
        thread = Executors.newSingleThreadScheduledExecutor(work -> {
            Thread made = new Thread(work, NAME);
            made.setDaemon(true);
            return made;
        });
        if (watchesDatabase()) {
            var unused = thread.scheduleWithFixedDelay(
                    this::lookAtDatabase, DATABASE_EVERY_MS, DATABASE_EVERY_MS, TimeUnit.MILLISECONDS);
        }
    }

    /** Whether the journal is kept in a database. */
    public boolean watchesDatabase() {
        return database.isPresent();
    }

    private void lookAtDatabase() {
        try {
            database.ifPresent(one -> one.look()
                    .ifPresentOrElse(health::report, () -> health.over(HealthKind.JOURNAL, DatabaseWatch.SUBJECT)));
        } catch (RuntimeException | Error fault) {
            guard.lost(NAME, fault); // the thread's owner would keep it, and not look again
        }
    }

    private static Optional<JournalWatch> watch(SqliteJournal journal, HealthModel health) {
        Path file = journal.file();
        try {
            return Optional.of(new JournalWatch(file, journal::bytes, health));
        } catch (IOException unseen) {
            LOG.log(Level.WARNING, "the disk of " + file + " is not watched: " + unseen.getMessage());
            return Optional.empty();
        }
    }

    /** Has it look, unless it looks still; to be called every second. From any thread. */
    public void look(long atMillis) {
        if (looking.compareAndSet(false, true)) {
            try {
                thread.execute(() -> {
                    try {
                        lookNow(atMillis);
                    } catch (RuntimeException | Error fault) {
                        guard.lost(NAME, fault); // the thread's owner would keep it
                    } finally {
                        looking.set(false);
                    }
                });
            } catch (RejectedExecutionException closed) {
                // the session ends
            }
        }
    }

    private void lookNow(long atMillis) {
        Runtime machine = Runtime.getRuntime();
        long most = machine.maxMemory();
        switch (memory.look(machine.totalMemory() - machine.freeMemory(), most)) {
            case NEARLY_NONE -> health.report(MemoryWatch.nearlyNone(most));
            case WELL -> health.over(HealthKind.MEMORY, "");
            case SAME -> {
                // an entry that is there stays
            }
        }
        if (looks++ % DISK_EVERY == 0) {
            journal.ifPresent(one -> one.look(atMillis));
        }
    }

    @Override
    public void close() {
        thread.shutdown();
    }
}
