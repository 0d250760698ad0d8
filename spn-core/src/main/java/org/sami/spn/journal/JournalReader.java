package org.sami.spn.journal;

import java.nio.file.Path;
import java.sql.Connection;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;

/**
 * Reads a journal, also one that is being written: what was durable when it was opened, or when it last read on. Used by one thread at a time.
 */
public final class JournalReader implements AutoCloseable {
    private final String where;
    private final Connection connection;
    private final boolean goesOn;
    private final TelemetryFrom telemetry;
    private final Closing closing;
    private Optional<JournalPart> kept;
    private Contents contents;
    private History history;

    private JournalReader(
            String where, Connection connection, Optional<JournalPart> known, TelemetryFrom telemetry, Closing closing)
            throws JournalException {
        this.where = where;
        this.connection = connection;
        this.telemetry = telemetry;
        this.closing = closing;
        Optional<Contents> on =
                known.isPresent() ? Scan.on(where, connection, known.get().contents()) : Optional.empty();
        goesOn = on.isPresent();
        kept = goesOn ? known : Optional.empty();
        contents = on.isPresent() ? on.get() : Scan.of(where, connection);
        history = history();
    }

    private History history() {
        return new History(where, connection, contents, kept.flatMap(JournalPart::state));
    }

    /** How what a reader reads is closed. */
    @FunctionalInterface
    private interface Closing {
        void close() throws JournalException;
    }

    /** Telemetry from a row on. */
    @FunctionalInterface
    private interface TelemetryFrom {
        TelemetryScan scan(long first);
    }

    /**
     * Reads it once and finds out how far it is true.
     *
     * @throws JournalException where not even the header is
     */
    public static JournalReader open(Path file) throws JournalException {
        return open(file, Optional.empty());
    }

    static JournalReader open(Path file, Optional<JournalPart> known) throws JournalException {
        JournalLock.checkName(file);
        Database database = Database.open(file);
        try {
            return new JournalReader(
                    file.toString(),
                    database.connection(),
                    known,
                    first -> new TelemetryScan(database, first),
                    database::close);
        } catch (JournalException refused) {
            database.close();
            throw refused;
        }
    }

    /**
     * Reads the tables of a journal in a database.
     *
     * @param where named in faults
     * @param connection on the journal's tables; nothing is written by it, and it is closed with the reader
     * @param known what was read before, and is not read again; where the journal is another one by now, all is
     * @throws JournalException where not even the header is true
     */
    public static JournalReader over(String where, Connection connection, Optional<JournalPart> known)
            throws JournalException {
        return new JournalReader(
                where,
                connection,
                known,
                first -> new TelemetryScan(connection, first),
                () -> close(where, connection));
    }

    private static void close(String where, Connection connection) throws JournalException {
        try {
            connection.close();
        } catch (SQLException fault) {
            throw new JournalException(where, 0, "cannot be closed: " + fault.getMessage(), fault);
        }
    }

    /** Whether it goes on from what was read before, and what that was is still so. */
    boolean goesOn() {
        return goesOn;
    }

    /**
     * Reads what was written since.
     *
     * @return false if another journal stands there than was read: this reader is of no use then
     */
    boolean readOn() throws JournalException {
        try {
            if (!connection.getAutoCommit()) {
                connection.commit(); // the transaction before shows nothing newer
            }
        } catch (SQLException fault) {
            throw new JournalException(where, lastIndex(), "cannot be read: " + fault.getMessage(), fault);
        }
        Optional<Contents> on = Scan.on(where, connection, contents);
        if (on.isEmpty()) {
            return false;
        }
        contents = on.get();
        history = history();
        return true;
    }

    /** The entries that were found to be valid. */
    JournalPart entriesRead() {
        return JournalPart.of(contents);
    }

    /** The telemetry from a row on. */
    TelemetryScan telemetryFrom(long first) {
        return telemetry.scan(first);
    }

    /**
     * The projects that the session has loaded, by the SHA-256 of their documents.
     *
     * @throws JournalException where they cannot be read
     */
    public Map<String, String> documents() throws JournalException {
        try {
            return new ProjectDocuments(connection).all();
        } catch (SQLException fault) {
            throw new JournalException(
                    where, lastIndex(), "has documents that cannot be read: " + fault.getMessage(), fault);
        }
    }

    /** What the journal says before its first entry. */
    public JournalHeader header() {
        return contents.header();
    }

    /** How far it is true. */
    public Recovery recovery() {
        return new Recovery(contents.lastValid(), contents.damage());
    }

    /** Index of the last valid entry; 0 where there is none. */
    public long lastIndex() {
        return contents.lastValid();
    }

    /** The session's time of the last valid entry; 0 where there is none. */
    public long lastMillis() {
        return contents.lastMillis();
    }

    /** The end of the chain of checksums, in hexadecimal digits: equal for journals of equal header and entries, wherever they are. */
    public String checksum() {
        return contents.lastChecksum().hex();
    }

    /** A snapshot's bytes; empty where its checksum does not hold. */
    Optional<byte[]> snapshot(long index) {
        return history.snapshot(index);
    }

    /** All valid entries, in order. */
    public List<JournalEntry> entries() throws JournalException {
        List<JournalEntry> all = new ArrayList<>();
        entries(1, lastIndex(), all::add);
        return all;
    }

    /** Valid entries from one to another, both included, in order, without holding them all. */
    public void entries(long first, long last, Consumer<JournalEntry> consumer) throws JournalException {
        history.entries(first - 1, Math.min(last, lastIndex()), consumer);
    }

    /**
     * The state after an entry, by the snapshot before it and replay; 0 is the state before the first.
     *
     * @param engine built from this journal's plans and vocabulary ({@link #header()})
     * @throws IllegalArgumentException if the index is not that of a valid entry
     */
    public EngineState stateAt(long index, Engine engine) throws JournalException {
        return history.stateAt(index, engine);
    }

    /**
     * Lets a listener hear entries again, from one to another, both included. Same plans and same journal give the same
     * effects as in the session (R-DET-1).
     */
    public void replay(Engine engine, long first, long last, HostListener listener) throws JournalException {
        history.replay(engine, first, last, listener);
    }

    /**
     * The marks of the simulated world, in order.
     *
     * @throws JournalException where one of them does not hold
     */
    public List<WorldMark> marks() throws JournalException {
        return history.marks();
    }

    /** The telemetry, in the order in which it was added, without what is damaged. Read again at each call, but for what was read before. */
    public Telemetry telemetry() {
        JournalPart.KeptTelemetry before = kept.map(JournalPart::telemetry).orElse(JournalPart.KeptTelemetry.NONE);
        Telemetry behind = telemetry.scan(before.next()).run();
        if (before.rows().isEmpty()) {
            return behind;
        }
        List<TelemetryRow> all = new ArrayList<>(before.rows());
        all.addAll(behind.rows());
        return new Telemetry(all, before.damage().or(behind::damage));
    }

    @Override
    public void close() throws JournalException {
        closing.close();
    }
}
