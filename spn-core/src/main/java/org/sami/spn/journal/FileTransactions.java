package org.sami.spn.journal;

import java.sql.SQLException;
import java.util.List;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;
import org.sami.spn.protocol.Input;

/**
 * The transactions in which a journal's file is written, with the telemetry that waits. After one failed nothing more is written before it was {@linkplain #undo
 * undone} and {@linkplain #recovered recovered}: the file's end is not known. Used by who holds the journal's lock.
 */
final class FileTransactions implements AutoCloseable {
    /** How what failed begins, for people. */
    static final String CANNOT = "cannot be written: ";

    private final Database database;
    private final JournalTables tables;
    private final ProjectDocuments documents;
    private final EntriesAhead ahead;
    private boolean broken;
    private String failure = "";

    FileTransactions(Database database, JournalTables tables) {
        this.database = database;
        this.tables = tables;
        this.documents = new ProjectDocuments(database.connection());
        this.ahead = new EntriesAhead("journal-writer of " + database.file(), this::writePart);
    }

    /** Begins to write the first entries of a batch, or those that follow them, on another thread; {@link #append} commits them. */
    void prepare(List<JournalEntry> part) {
        if (!broken) {
            ahead.write(part);
        }
    }

    /** Undoes what was prepared. */
    void withdraw() {
        if (ahead.hasBegun()) {
            ahead.giveUp();
            database.rollBack();
            tables.undone();
        }
    }

    /** Writes a batch, or of one that was prepared what is left, and commits it. */
    void append(List<JournalEntry> batch) throws JournalException {
        commit(batch.get(0).index(), () -> {
            int written = ahead.takeOver();
            if (written < batch.size()) {
                writePart(batch.subList(written, batch.size()), written == 0);
            }
        });
    }

    private void writePart(List<JournalEntry> entries, boolean isFirst) throws SQLException {
        if (isFirst) {
            begin();
        }
        if (entries.stream().anyMatch(entry -> entry.input() instanceof Input.LoadProject)) {
            documents.makeTable();
        }
        tables.write(entries);
    }

    /**
     * One transaction of something else than entries.
     *
     * @param entry named where it fails
     */
    void run(long entry, Writing writing) throws JournalException {
        withdraw();
        commit(entry, () -> {
            begin();
            writing.run();
        });
    }

    private void begin() throws SQLException {
        database.run("BEGIN IMMEDIATE");
    }

    private void commit(long entry, Writing writing) throws JournalException {
        check(entry);
        broken = true;
        try {
            writing.run();
            tables.writeTelemetry();
            database.run("COMMIT");
            tables.committed();
            broken = false;
        } catch (SQLException fault) {
            failure = Database.words(fault);
            throw new JournalException(database.file(), entry, CANNOT + failure, fault);
        }
    }

    /** Makes sure that the last one has not failed. */
    void check(long entry) throws JournalException {
        if (broken) {
            throw new JournalException(database.file(), entry, CANNOT + failure);
        }
    }

    /** Whether one has failed. */
    boolean isBroken() {
        return broken;
    }

    /** Whether nothing is being written for a batch that is not complete, and none has failed. */
    boolean isIdle() {
        return !broken && !ahead.hasBegun();
    }

    /** Waits until no other thread uses the connection. */
    void await() {
        ahead.await();
    }

    /** Undoes one that failed. */
    void undo() {
        ahead.giveUp();
        database.rollBack();
    }

    /** The file's end is known again. */
    void recovered() {
        broken = false;
    }

    @Override
    public void close() {
        ahead.close();
    }

    /** What is written in a transaction. */
    @FunctionalInterface
    interface Writing {
        void run() throws SQLException;
    }
}
