package org.sami.spn.journal;

import java.nio.charset.StandardCharsets;
import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.engine.RuleVersion;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;
import org.sami.spn.protocol.Input;

/**
 * What a journal is in any database: its tables on a connection, and the end of its chain (docs/decisions 0031). Whoever owns the journal begins and commits transactions, and says
 * so by {@link #committed}. Telemetry may be added from any thread; everything else is for one thread at a time.
 */
public final class JournalTables {
    private final String where;
    private final JournalHeader header;
    private final Recovery recovery;
    private final HashChain chain = new HashChain();
    private final SnapshotSchedule schedule;
    private final TelemetryTable telemetry = new TelemetryTable();
    private JournalPart read;
    private Connection connection;
    private RowWriter writer;
    private Attachments attachments;
    private ProjectDocuments documents;
    private End end;
    private Optional<End> attempted = Optional.empty();

    /** Where the journal ends after a batch. */
    private record End(Checksum checksum, long index, long millis) {}

    JournalTables(
            String where,
            Connection connection,
            RowWriter writer,
            Contents contents,
            Recovery recovery,
            JournalOptions options) {
        this.where = where;
        this.header = contents.header();
        this.read = JournalPart.of(contents);
        this.recovery = recovery;
        this.schedule = new SnapshotSchedule(options, contents.snapshots().keySet());
        this.end = new End(contents.lastChecksum(), contents.lastValid(), contents.lastMillis());
        this.connection = connection;
        this.writer = writer;
        this.attachments = new Attachments(connection);
        this.documents = new ProjectDocuments(connection);
    }

    /** Writes the header of a journal that begins; the caller commits. */
    public static void begin(Connection connection, JournalHeader header) throws SQLException {
        HeaderTable.write(connection, header);
    }

    /**
     * The header of a journal, read alone.
     *
     * @param where named in faults
     * @throws JournalException where it does not hold, or the journal's missions ran by other rules of firing ({@link RuleVersion})
     */
    public static JournalHeader header(String where, Connection connection) throws JournalException {
        JournalHeader header = HeaderTable.read(where, connection).header();
        refuseOtherRules(where, header);
        return header;
    }

    /**
     * Goes through a whole journal once, to go on after its last valid entry. Nothing is changed.
     *
     * @param where named in faults
     * @param known what was read before, and is not read again; where the journal is another one by now, all is
     * @throws JournalException where its header does not hold, or its missions ran by other rules of firing ({@link RuleVersion})
     */
    public static JournalTables open(
            String where, Connection connection, RowWriter writer, Optional<JournalPart> known, JournalOptions options)
            throws JournalException {
        Optional<Contents> on =
                known.isPresent() ? Scan.on(where, connection, known.get().contents()) : Optional.empty();
        Contents contents = on.isPresent() ? on.get() : Scan.of(where, connection);
        refuseOtherRules(where, contents.header());
        JournalTables tables = new JournalTables(
                where, connection, writer, contents, new Recovery(contents.lastValid(), contents.damage()), options);
        tables.read = new JournalPart(
                contents,
                on.isPresent() ? known.flatMap(JournalPart::state) : Optional.empty(),
                on.isPresent() ? known.get().telemetry() : JournalPart.KeptTelemetry.NONE);
        return tables;
    }

    static void refuseOtherRules(String where, JournalHeader header) throws JournalException {
        Optional<String> other = RuleVersion.difference(header.settings());
        if (other.isPresent()) {
            throw new JournalException(where, 0, other.get());
        }
    }

    /** The journal's header. */
    public JournalHeader header() {
        return header;
    }

    /** What was read when it was opened, with what was known before; only the first call gives a state and telemetry, which take room and are not kept. */
    public JournalPart takeRead() {
        JournalPart taken = read;
        read = read.entriesOnly();
        return taken;
    }

    /** What was found when it was opened. */
    public Recovery recovery() {
        return recovery;
    }

    /** Index of the last entry that was committed. */
    public long lastIndex() {
        return end.index;
    }

    /** The session's time of that entry. */
    public long lastMillis() {
        return end.millis;
    }

    /**
     * Makes sure that entries follow those that are there.
     *
     * @throws IllegalArgumentException if they do not
     */
    public void checkFollows(List<JournalEntry> batch) {
        long expected = end.index;
        long millis = end.millis;
        for (JournalEntry entry : batch) {
            expected++;
            if (entry.index() != expected || entry.atMillis() < millis) {
                throw new IllegalArgumentException("entry " + expected + " at or after " + millis
                        + " ms expected, not entry " + entry.index() + " at " + entry.atMillis() + " ms");
            }
            millis = entry.atMillis();
        }
    }

    /** Writes entries, behind those that were written since the last commit, with the documents of projects that they load. */
    public void write(List<JournalEntry> batch) throws SQLException {
        Checksum checksum = attempted.orElse(end).checksum;
        List<RowWriter.EntryRow> rows = new ArrayList<>(batch.size());
        for (JournalEntry entry : batch) {
            if (entry.input() instanceof Input.LoadProject load) {
                documents.add(load);
            }
            String input = InputText.write(entry.input());
            byte[] bytes = input.getBytes(StandardCharsets.UTF_8);
            schedule.grew(bytes.length);
            checksum = chain.entry(checksum, entry.index(), entry.atMillis(), bytes);
            rows.add(new RowWriter.EntryRow(entry.index(), entry.atMillis(), input, checksum));
        }
        writer.entries(rows);
        JournalEntry last = batch.get(batch.size() - 1);
        attempted = Optional.of(new End(checksum, last.index(), last.atMillis()));
    }

    /** Whether a snapshot is to be written. */
    public boolean isSnapshotDue() {
        return schedule.isDue(end.index);
    }

    /** Writes a snapshot of the state after the last entry, and deletes those that are given up. */
    public void writeSnapshot(byte[] state) throws SQLException {
        attachments.writeSnapshot(end.index, end.checksum, state);
        attachments.dropSnapshots(schedule.written(end.index, state.length));
    }

    /** The snapshot was committed. */
    public void snapshotCommitted() {
        schedule.committed(end.index);
    }

    /** Writes a mark after the last entry, in place of one that is there. */
    public void writeMark(String text) throws SQLException {
        attachments.writeMark(end.index, end.checksum, text);
    }

    /** Takes telemetry, from any thread; where too much waits already it is counted and let go. */
    public void addTelemetry(List<TelemetryRow> rows) {
        telemetry.add(rows);
    }

    /** Whether telemetry waits to be written. */
    public boolean hasTelemetry() {
        return !telemetry.isEmpty();
    }

    /** How many rows of telemetry were let go. */
    public long telemetryLost() {
        return telemetry.lost();
    }

    /** Writes the telemetry that waits. */
    public void writeTelemetry() throws SQLException {
        telemetry.write(writer);
    }

    /** All that was written since is in the database. */
    public void committed() {
        telemetry.committed();
        attempted.ifPresent(this::endsAt);
    }

    private void endsAt(End last) {
        end = last;
        attempted = Optional.empty();
    }

    /** What was written since the last commit is not in the database: its transaction was undone. */
    void undone() {
        attempted = Optional.empty();
    }

    /** Goes on by another connection, after the one before failed. */
    public void reconnected(Connection other, RowWriter itsWriter) {
        connection = other;
        writer = itsWriter;
        attachments = new Attachments(other);
        documents = new ProjectDocuments(other);
    }

    /**
     * Looks, after a commit failed, whether its entries are in the database all the same; from then on {@link #lastIndex} says it.
     *
     * @throws JournalException if the journal ends neither before nor after them
     */
    public void findEnd() throws SQLException, JournalException {
        if (attempted.isPresent() && endsWith(attempted.get())) {
            endsAt(attempted.get()); // it was written, and only the word for it did not come
        } else if (!endsWith(end)) {
            throw new JournalException(where, end.index, "ends otherwise than it was written");
        }
        attempted = Optional.empty();
    }

    private boolean endsWith(End wanted) throws SQLException {
        try (Statement statement = connection.createStatement();
                ResultSet last =
                        statement.executeQuery("SELECT idx, checksum FROM entries ORDER BY idx DESC LIMIT 1")) {
            return last.next()
                    ? last.getLong(1) == wanted.index && wanted.checksum.is(Scan.bytes(last, 2))
                    : wanted.index == 0;
        }
    }
}
