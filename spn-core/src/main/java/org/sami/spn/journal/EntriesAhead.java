package org.sami.spn.journal;

import java.sql.SQLException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.sami.spn.host.JournalEntry;

/**
 * Writes the first entries of a batch on a thread of its own while the engine takes the rest of the batch (docs/decisions 0640). What it writes is in a transaction
 * that somebody else commits. Used by who holds the journal's lock.
 */
final class EntriesAhead implements AutoCloseable {
    private final Part part;
    private final ExecutorService thread;
    private final Deque<List<JournalEntry>> waiting = new ArrayDeque<>();
    private int written;
    private boolean isScheduled;
    private boolean isWriting;
    private boolean hasBegun;
    private @Nullable Throwable fault;

    /**
     * Its thread begins with the first part.
     *
     * @param name of its thread
     * @param part writes some entries; the first of a batch begin the transaction
     */
    EntriesAhead(String name, Part part) {
        this.part = part;
        this.thread = Executors.newSingleThreadExecutor(action -> {
            Thread made = new Thread(action, name);
            made.setDaemon(true);
            return made;
        });
    }

    /** Some entries of a batch follow those that were given before. After one part failed no further one is written. */
    synchronized void write(List<JournalEntry> entries) {
        hasBegun = true;
        waiting.add(entries);
        if (!isScheduled) {
            isScheduled = true;
            thread.execute(this::writeAll);
        }
    }

    private void writeAll() {
        for (List<JournalEntry> next = next(); next != null; next = next()) {
            Throwable met = null;
            try {
                part.write(next, written == 0);
            } catch (SQLException | RuntimeException | Error refused) {
                met = refused;
            }
            ended(next.size(), met);
        }
    }

    private synchronized @Nullable List<JournalEntry> next() {
        List<JournalEntry> next = waiting.poll();
        isWriting = next != null;
        isScheduled = next != null;
        return next;
    }

    private synchronized void ended(int entries, @Nullable Throwable met) {
        isWriting = false;
        if (met == null) {
            written += entries;
        } else {
            fault = met;
            waiting.clear();
        }
        notifyAll();
    }

    /** Whether entries were given that nobody has taken over or given up. */
    synchronized boolean hasBegun() {
        return hasBegun;
    }

    /** Waits until all that was given is written, or was refused. */
    synchronized void await() {
        waitWhile(() -> isWriting || !waiting.isEmpty());
    }

    /**
     * Lets its thread write no further part, and waits for the one that it writes: on a busy machine the caller is sooner done with the rest.
     *
     * @return how many entries of the batch are written; 0 where no transaction has begun
     * @throws SQLException if some were refused: the transaction is to be undone
     */
    synchronized int takeOver() throws SQLException {
        Throwable met = stop();
        int entries = written;
        forget();
        if (met instanceof SQLException refused) {
            throw refused;
        }
        if (met != null) {
            throw new IllegalStateException("entries could not be written", met);
        }
        return entries;
    }

    /** Waits for the thread; what it has written is to be undone. */
    synchronized void giveUp() {
        stop();
        forget();
    }

    private @Nullable Throwable stop() {
        waiting.clear();
        waitWhile(() -> isWriting);
        return fault;
    }

    /** Also for a thread that is interrupted: the connection can be used by one only. */
    private void waitWhile(BooleanSupplier condition) {
        boolean interrupted = false;
        while (condition.getAsBoolean()) {
            try {
                wait();
            } catch (InterruptedException stopped) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private void forget() {
        written = 0;
        hasBegun = false;
        fault = null;
    }

    @Override
    public void close() {
        thread.shutdown();
    }

    /** Writes a part of a batch. */
    @FunctionalInterface
    interface Part {
        void write(List<JournalEntry> entries, boolean isFirst) throws SQLException;
    }
}
