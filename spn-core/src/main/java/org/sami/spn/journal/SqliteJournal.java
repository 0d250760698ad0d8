package org.sami.spn.journal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.PreparedStatement;
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

/**
 * A session's journal, open for writing (docs/decisions 0030, 0031, 0032). One writer at a time; others may read meanwhile
 * with {@link JournalReader}. Telemetry may be added from any thread, everything else is called by the owner of the
 * engine.
 *
 * <p>What a committed batch survives: the death of the process always; the loss of power within
 * {@link JournalOptions#syncWithinMillis()}, or before {@link #append} returns where that was asked for.
 */
public final class SqliteJournal implements StoredJournal {
    private static final String CLOSED = "the journal is closed";

    private final Path file;
    private final JournalLock lock;
    private final Database database;
    private final JournalOptions options;
    private final PowerSync power;
    private final LogCheckpoints checkpoints;
    private final EntryTable entries;
    private final JournalTables tables;
    private final FileTransactions transactions;
    private final History history;
    private volatile boolean closed;

    private SqliteJournal(
            JournalLock lock, Database database, Contents contents, Optional<String> damage, JournalOptions options)
            throws SQLException {
        this.file = database.file();
        this.lock = lock;
        this.database = database;
        this.options = options;
        this.entries = new EntryTable(database.connection());
        this.tables = new JournalTables(
                file.toString(),
                database.connection(),
                new Rows(),
                contents,
                new Recovery(contents.lastValid(), damage),
                options);
        this.transactions = new FileTransactions(database, tables);
        this.history = new History(file.toString(), database.connection(), contents, Optional.empty());
        this.checkpoints = new LogCheckpoints(file, options.checkpointsBeside() ? options.checkpointPages() : 0);
        this.power =
                new PowerSync(Database.log(file), options.syncWithinMillis(), this::writeTelemetry, checkpoints::look);
    }

    /** As many rows a statement as are quick in a file. */
    private final class Rows implements RowWriter {
        @Override
        public void entries(List<EntryRow> rows) throws SQLException {
            entries.write(rows);
        }

        @Override
        public void telemetry(List<SummedTelemetry> rows) throws SQLException {
            try (PreparedStatement insert = TelemetryTable.insertion(database.connection())) {
                for (SummedTelemetry row : rows) {
                    TelemetryTable.insert(insert, row.row(), row.sum());
                }
            }
        }
    }

    /**
     * A new journal; its header is in the file, and survives the loss of power, when this returns.
     *
     * @throws JournalException if the file exists, or cannot be made
     */
    public static SqliteJournal create(Path file, JournalHeader header, JournalOptions options) throws IOException {
        JournalLock lock = JournalLock.take(file);
        try {
            Contents contents = Rebuild.begin(file, header, options);
            lock.takeFile(file);
            return opened(lock, Database.open(file), contents, Optional.empty(), options);
        } catch (IOException fault) {
            lock.close();
            throw fault;
        }
    }

    /**
     * Opens an existing journal to go on after its last valid entry. Where the file is damaged behind that entry, the
     * valid part is written again and the damaged file is kept next to it; {@link #recovery()} says so.
     *
     * @throws JournalException if it is written by somebody else, its header does not hold, or its missions ran by other rules of firing
     *     ({@link org.sami.spn.engine.RuleVersion})
     */
    public static SqliteJournal open(Path name, JournalOptions options) throws IOException {
        Path file = JournalLock.file(name);
        JournalLock lock = JournalLock.take(file);
        try {
            if (Files.isRegularFile(file)) {
                lock.takeFile(file);
            }
            Database database = Database.open(file);
            Contents contents;
            Optional<String> damage;
            try {
                contents = Scan.of(file.toString(), database.connection());
                JournalTables.refuseOtherRules(file.toString(), contents.header());
                damage = contents.damage().or(() -> unsound(database));
            } catch (JournalException refused) {
                database.close();
                throw refused;
            }
            if (damage.isEmpty()) {
                return opened(lock, database, contents, damage, options);
            }
            Rebuild.Rebuilt anew = Rebuild.of(database, contents, options);
            lock.takeFile(file);
            Optional<String> told = damage.map(what -> what
                    + anew.telemetryDamage().map(lost -> "; " + lost).orElse("") + "; the damaged file is kept as "
                    + anew.kept().getFileName());
            Database rebuilt = Database.open(file);
            return opened(lock, rebuilt, Scan.of(file.toString(), rebuilt.connection()), told, options);
        } catch (IOException fault) {
            lock.close();
            throw fault;
        }
    }

    private static Optional<String> unsound(Database database) {
        return database.isSound() ? Optional.empty() : Optional.of("the file's inner structure is damaged");
    }

    private static SqliteJournal opened(
            JournalLock lock, Database database, Contents contents, Optional<String> damage, JournalOptions options)
            throws JournalException {
        try {
            database.restrict();
            database.prepareWriting(options);
            database.addTelemetrySums();
            return new SqliteJournal(lock, database, contents, damage, options);
        } catch (SQLException fault) {
            database.close();
            throw new JournalException(database.file(), 0, "cannot be written: " + fault.getMessage(), fault);
        }
    }

    @Override
    public JournalHeader header() {
        return tables.header();
    }

    @Override
    public Recovery recovery() {
        return tables.recovery();
    }

    @Override
    public Optional<Path> inFile() {
        return Optional.of(file);
    }

    @Override
    public JournalReader reader() throws JournalException {
        return JournalReader.open(file);
    }

    /** Its file. */
    public Path file() {
        return file;
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
        if (batch.isEmpty()) {
            return;
        }
        checkOpen(lastIndex() + 1);
        transactions.append(batch);
        if (durability == Durability.POWER && options.syncCommands()) {
            sync();
        } else {
            power.soon();
        }
    }

    /** Begins to write them on a thread of its own. */
    @Override
    public synchronized void prepare(List<JournalEntry> entries) {
        if (!closed) {
            transactions.prepare(entries);
        }
    }

    @Override
    public synchronized void withdraw() {
        transactions.withdraw();
    }

    @Override
    public synchronized void check() throws IOException {
        checkOpen(lastIndex());
        transactions.check(lastIndex());
    }

    @Override
    public synchronized boolean isRecoverable() {
        return !closed;
    }

    /** Also writes the telemetry that waits: when this returns the disk has taken something. */
    @Override
    public synchronized void recover() throws IOException {
        checkOpen(lastIndex());
        try {
            transactions.undo();
            tables.findEnd();
            entries.close();
            if (power.hasFailed()) {
                database.rewriteLog();
                power.recovered();
            }
            transactions.recovered();
            commit(() -> {});
        } catch (SQLException fault) {
            throw new JournalException(file, lastIndex(), FileTransactions.CANNOT + Database.words(fault), fault);
        }
    }

    /** How large its file is, with the content of the log next to it. */
    public synchronized long bytes() throws IOException {
        transactions.await();
        try {
            return database.bytes();
        } catch (SQLException fault) {
            throw new JournalException(file, lastIndex(), "cannot be read: " + fault.getMessage(), fault);
        }
    }

    /** How many rows of telemetry were let go, since the file could not be written for too long. */
    public long telemetryLost() {
        return tables.telemetryLost();
    }

    /** For tests: a disk on which the file has room for so many further pages. */
    synchronized void leaveRoomFor(long pages) throws SQLException {
        database.limitPages(database.bytes() / options.pageBytes() + pages);
    }

    @Override
    public synchronized void offerSnapshot(Supplier<byte[]> state) throws IOException {
        if (tables.isSnapshotDue()) {
            byte[] bytes = state.get();
            commit(() -> tables.writeSnapshot(bytes));
            tables.snapshotCommitted();
        }
    }

    @Override
    public synchronized void mark(String text) throws IOException {
        Objects.requireNonNull(text, "text");
        commit(() -> tables.writeMark(text));
    }

    /** It is in the file within the time of a sync, or with the next batch. */
    @Override
    public void addTelemetry(List<TelemetryRow> rows) throws IOException {
        if (closed) { // only then the journal's lock, for which others would wait until a batch is written
            throw new JournalException(file, lastIndex(), CLOSED);
        }
        tables.addTelemetry(rows);
        if (!power.hasFailed()) {
            power.soon();
        }
    }

    @Override
    public synchronized void sync() throws IOException {
        if (options.everSyncs()) {
            power.now();
        }
    }

    @Override
    public synchronized EngineState restore(Engine engine) throws JournalException {
        return history.stateAt(recovery().lastValid(), engine);
    }

    private synchronized void writeTelemetry() throws IOException {
        if (!closed && transactions.isIdle() && tables.hasTelemetry()) {
            commit(() -> {});
        }
    }

    private void commit(FileTransactions.Writing writing) throws JournalException {
        checkOpen(lastIndex());
        transactions.run(lastIndex(), writing);
    }

    private void checkOpen(long entry) throws JournalException {
        if (closed) {
            throw new JournalException(file, entry, CLOSED);
        }
    }

    /** Folds the log into the file, so that one file is left, and gives up the right to write. */
    @Override
    public synchronized void close() throws IOException {
        if (closed) {
            return;
        }
        transactions.withdraw();
        try (JournalLock released = lock;
                Database ended = database;
                PowerSync stopped = power;
                FileTransactions over = transactions) {
            checkpoints.close();
            if (!transactions.isBroken()) {
                writeTelemetry();
                entries.close();
                database.checkpoint();
            }
        } catch (SQLException fault) {
            throw new JournalException(file, lastIndex(), "cannot be closed: " + fault.getMessage(), fault);
        } finally {
            closed = true;
        }
    }
}
