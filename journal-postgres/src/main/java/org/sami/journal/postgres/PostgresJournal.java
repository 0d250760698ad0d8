package org.sami.journal.postgres;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.SQLException;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.JournalPart;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.JournalTables;
import org.sami.spn.journal.Recovery;
import org.sami.spn.journal.StoredJournal;
import org.sami.spn.journal.TelemetryRow;

/**
 * A session's journal in PostgreSQL, open for writing by the holder of its lease (docs/decisions 0493). Each transaction looks first whether the lease is still held, and fails where it is
 * not: what a superseded base writes is not in the journal. Telemetry may be added from any thread, everything else is called by the owner of the engine.
 *
 * <p>What a committed batch survives: the death of this process and of the database always, but for a session that only simulates; on a standby as well where the database has a synchronous
 * one and {@link Durability#POWER} was asked for.
 */
final class PostgresJournal implements StoredJournal {
    private static final String CANNOT = "cannot be written";
    private static final String CLOSED = "the journal is closed";

    private final PostgresAddress address;
    private final Lease lease;
    private final JournalOptions options;
    private final JournalTables tables;
    private final Recovery recovery;
    private final TelemetryFlush flush;
    private final LateWriting late;
    private volatile JournalPart read;
    private Connection connection;
    private String commitMode = "";
    private Optional<String> broken = Optional.empty();
    private volatile boolean closed;

    /**
     * A journal that is open.
     *
     * @param connection without a transaction; closed with this
     * @param lease closed with this
     */
    PostgresJournal(
            PostgresAddress address,
            Connection connection,
            Lease lease,
            JournalTables tables,
            Recovery recovery,
            JournalOptions options) {
        this.address = address;
        this.connection = connection;
        this.lease = lease;
        this.tables = tables;
        this.read = tables.takeRead();
        this.recovery = recovery;
        this.options = options;
        this.flush = new TelemetryFlush("journal-telemetry of " + address.words(), this::writeTelemetry);
        this.late = new LateWriting("journal-late of " + address.words(), lease);
    }

    @Override
    public Optional<Path> inFile() {
        return Optional.empty();
    }

    @Override
    public JournalReader reader() throws JournalException {
        return PostgresReading.open(address, Optional.of(read));
    }

    @Override
    public JournalHeader header() {
        return tables.header();
    }

    @Override
    public Recovery recovery() {
        return recovery;
    }

    @Override
    public long epoch() {
        return lease.epoch();
    }

    @Override
    public synchronized long lastIndex() {
        return tables.lastIndex();
    }

    @Override
    public synchronized long lastMillis() {
        return tables.lastMillis();
    }

    @Override
    public synchronized void append(List<JournalEntry> batch, Durability durability) throws IOException {
        tables.checkFollows(batch);
        if (!batch.isEmpty()) {
            commit(lastIndex() + 1, durability, () -> tables.write(batch));
        }
    }

    @Override
    public synchronized void offerSnapshot(Supplier<byte[]> state) throws IOException {
        if (tables.isSnapshotDue()) {
            byte[] bytes = state.get();
            commit(lastIndex(), Durability.PROCESS, () -> tables.writeSnapshot(bytes));
            tables.snapshotCommitted();
        }
    }

    @Override
    public synchronized void mark(String text) throws IOException {
        Objects.requireNonNull(text, "text");
        commit(lastIndex(), Durability.PROCESS, () -> tables.writeMark(text));
    }

    @Override
    public void addTelemetry(List<TelemetryRow> rows) throws IOException {
        if (closed) {
            throw new JournalException(address.words(), lastIndex(), CLOSED);
        }
        tables.addTelemetry(rows);
        flush.soon();
    }

    private synchronized void writeTelemetry() throws IOException {
        if (!closed && broken.isEmpty() && tables.hasTelemetry()) {
            commit(lastIndex(), Durability.PROCESS, () -> {});
        }
    }

    /** What was appended is durable already; a session that only simulates has nothing to lose but its process. */
    @Override
    public synchronized void sync() throws IOException {
        checkWritable(lastIndex());
    }

    @Override
    public synchronized void check() throws IOException {
        checkWritable(lastIndex());
    }

    @Override
    public synchronized boolean isRecoverable() {
        return !closed && !lease.isSuperseded();
    }

    @Override
    public boolean isTakenOver() {
        return lease.isSuperseded();
    }

    @Override
    public Optional<String> warning() {
        return closed || broken.isPresent() ? Optional.empty() : lease.warning();
    }

    /** Connects again, takes the lease up where nobody else has taken it, and looks how far the journal goes. Also writes the telemetry that waits. */
    @Override
    public synchronized void recover() throws IOException {
        if (closed) {
            throw new JournalException(address.words(), lastIndex(), CLOSED);
        }
        Connections.drop(connection);
        try {
            connection = Connections.toWrite(address);
            commitMode = "";
            if (!lease.renewBy(connection)) {
                connection.rollback();
                throw new JournalException(
                        address.words(),
                        lastIndex(),
                        CANNOT + ": " + lease.lost().orElse(""));
            }
            connection.commit();
            tables.reconnected(connection, new PostgresRows(connection));
            tables.findEnd();
            connection.commit();
            broken = Optional.empty();
            commit(lastIndex(), Durability.PROCESS, () -> {});
        } catch (SQLException fault) {
            throw DatabaseFaults.of(address, lastIndex(), CANNOT, fault);
        }
    }

    @Override
    public synchronized EngineState restore(Engine engine) throws IOException {
        try (JournalReader reader = reader()) {
            return reader.stateAt(recovery.lastValid(), engine);
        }
    }

    @Override
    public void begun() {
        read = read.entriesOnly();
    }

    /** One transaction, with the lease and the telemetry that waits. After a failure nothing more is written before {@link #recover}: the journal's end is not known. */
    private void commit(long entry, Durability durability, Writing writing) throws JournalException {
        checkWritable(entry);
        late.begins(connection);
        try {
            setDurability(durability);
            Optional<String> lost = lease.lock(connection);
            if (lost.isPresent()) {
                connection.rollback();
                broken = lost;
                throw new JournalException(address.words(), entry, CANNOT + ": " + lost.get());
            }
            writing.run();
            tables.writeTelemetry();
            connection.commit();
            tables.committed();
        } catch (SQLException fault) {
            String why = lease.lost().orElseGet(() -> DatabaseFaults.words(fault));
            broken = Optional.of(why);
            throw new JournalException(address.words(), entry, CANNOT + ": " + why, fault);
        } finally {
            late.isOver();
        }
    }

    private void setDurability(Durability durability) throws SQLException {
        String mode = !options.syncCommands() ? "off" : durability == Durability.POWER ? "on" : "local";
        if (!mode.equals(commitMode)) {
            commitMode = ""; // a rollback takes the setting back
            Connections.run(connection, "SET synchronous_commit = " + mode);
            connection.commit();
            commitMode = mode;
        }
    }

    private void checkWritable(long entry) throws JournalException {
        if (closed) {
            throw new JournalException(address.words(), entry, CLOSED);
        }
        Optional<String> why = lease.lost().or(() -> broken);
        if (why.isPresent()) {
            broken = why;
            throw new JournalException(address.words(), entry, CANNOT + ": " + why.get());
        }
    }

    /** Writes the telemetry that waits, and gives the lease back. */
    @Override
    public void close() throws IOException {
        flush.close();
        synchronized (this) {
            if (closed) {
                return;
            }
            try (Lease given = lease;
                    LateWriting ended = late) {
                writeTelemetry();
            } finally {
                closed = true;
                Connections.drop(connection);
            }
        }
    }

    @FunctionalInterface
    private interface Writing {
        void run() throws SQLException;
    }
}
