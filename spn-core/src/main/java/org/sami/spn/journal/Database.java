package org.sami.spn.journal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import org.sami.spn.host.JournalException;
import org.sami.spn.sqlite.SqliteLibrary;
import org.sqlite.SQLiteConfig;
import org.sqlite.SQLiteErrorCode;
import org.sqlite.SQLiteOpenMode;

/** One connection to a journal's file, and the tables in it. */
final class Database implements AutoCloseable {
    /** Marks the file as a journal of SAMI ("SAMI" in ASCII). */
    private static final int APPLICATION_ID = 0x53414d49;

    /** How many times as long as it should be the log may become before whoever commits folds it. */
    private static final int LONGEST_LOG = 4;

    private static final String[] TABLES = {
        "CREATE TABLE header (pos INTEGER PRIMARY KEY, kind TEXT NOT NULL, name TEXT NOT NULL, content TEXT NOT NULL)"
                + " STRICT",
        "CREATE TABLE entries (idx INTEGER PRIMARY KEY, at_millis INTEGER NOT NULL, input TEXT NOT NULL,"
                + " checksum BLOB NOT NULL) STRICT",
        "CREATE TABLE snapshots (idx INTEGER PRIMARY KEY, state BLOB NOT NULL, checksum BLOB NOT NULL) STRICT",
        "CREATE TABLE marks (idx INTEGER PRIMARY KEY, mark TEXT NOT NULL, checksum BLOB NOT NULL) STRICT",
        "CREATE TABLE telemetry (pos INTEGER PRIMARY KEY, at_millis INTEGER NOT NULL, proxy TEXT NOT NULL,"
                + " kind TEXT NOT NULL, json TEXT NOT NULL, sum INTEGER NOT NULL)"
                + " STRICT"
    };

    private final Path file;
    private final Connection connection;

    private Database(Path file, Connection connection) {
        this.file = file;
        this.connection = connection;
    }

    /** A new file with empty tables; not committed. */
    static Database create(Path file, JournalOptions options) throws JournalException {
        if (Files.exists(file)) {
            throw new JournalException(file, 0, "exists already; a journal is never written over");
        }
        try {
            PrivateFiles.makeFile(file); // SQLite gives its log the same permissions
        } catch (IOException fault) {
            throw new JournalException(file, 0, "cannot be made: " + fault.getMessage(), fault);
        }
        Database database = new Database(file, connect(file, new SQLiteConfig()));
        try {
            database.run("PRAGMA page_size=" + options.pageBytes());
            database.run("PRAGMA application_id=" + APPLICATION_ID);
            database.run("PRAGMA journal_mode=WAL");
            database.prepareWriting(options);
            database.connection.setAutoCommit(false);
            for (String table : TABLES) {
                database.run(table);
            }
            return database;
        } catch (SQLException fault) {
            database.close();
            throw new JournalException(file, 0, "cannot be made: " + fault.getMessage(), fault);
        }
    }

    /** An existing file. */
    static Database open(Path file) throws JournalException {
        if (!Files.isRegularFile(file)) {
            throw new JournalException(file, 0, "is not there");
        }
        SQLiteConfig config = new SQLiteConfig();
        config.resetOpenMode(SQLiteOpenMode.CREATE);
        Database database = new Database(file, connect(file, config));
        try {
            database.run("PRAGMA trusted_schema=OFF"); // whatever stands in the file calls no function
            if (database.number("PRAGMA application_id") != APPLICATION_ID) {
                throw new JournalException(file, 0, "is no journal of SAMI");
            }
            JournalSchema.check(file, database.connection);
            return database;
        } catch (SQLException fault) {
            database.close();
            String what = fault.getErrorCode() == SQLiteErrorCode.SQLITE_NOTADB.code
                    ? "is no journal of SAMI, or its first bytes are damaged"
                    : "cannot be read: " + fault.getMessage();
            throw new JournalException(file, 0, what, fault);
        } catch (JournalException other) {
            database.close();
            throw other;
        }
    }

    private static Connection connect(Path file, SQLiteConfig config) throws JournalException {
        SqliteLibrary.choose();
        config.setGetGeneratedKeys(false); // nobody asks for them, and the driver would query them after each statement
        try {
            return config.createConnection("jdbc:sqlite:" + file.toAbsolutePath());
        } catch (SQLException fault) {
            throw new JournalException(file, 0, "cannot be opened: " + fault.getMessage(), fault);
        }
    }

    /** Sets this connection up for writing. Where another folds the log, this one does it only if it grows nevertheless, as each commit then waits for the disk. */
    void prepareWriting(JournalOptions options) throws SQLException {
        run("PRAGMA synchronous=" + (options.everSyncs() ? "NORMAL" : "OFF"));
        int pages = options.checkpointPages();
        run("PRAGMA wal_autocheckpoint=" + (options.checkpointsBeside() ? pages * LONGEST_LOG : pages));
    }

    /** Has telemetry carry checksums also in a file of the time when it had none; what is there stays without. */
    void addTelemetrySums() throws SQLException {
        if (!hasTelemetrySums()) {
            run("ALTER TABLE telemetry ADD COLUMN sum INTEGER");
        }
    }

    boolean hasTelemetrySums() throws SQLException {
        return number("SELECT count(*) FROM pragma_table_info('telemetry') WHERE name = 'sum'") > 0;
    }

    /** Whether telemetry carried checksums from the file's beginning. */
    boolean hasAllTelemetrySums() throws SQLException {
        return number("SELECT count(*) FROM pragma_table_info('telemetry') WHERE name = 'sum' AND \"notnull\" = 1") > 0;
    }

    /** Whether SQLite finds its own structure whole and lets us write. */
    boolean isSound() {
        try {
            if (!"ok".equals(text("PRAGMA quick_check(1)"))) {
                return false;
            }
            run("BEGIN IMMEDIATE");
            run("COMMIT");
            return true;
        } catch (SQLException damage) {
            return false;
        }
    }

    Connection connection() {
        return connection;
    }

    Path file() {
        return file;
    }

    /** Why the file cannot be written, for people. */
    static String words(SQLException fault) {
        int code = fault.getErrorCode() & 0xff; // the rest says more of an error of the disk
        if (code == SQLiteErrorCode.SQLITE_FULL.code) {
            return "the disk is full";
        }
        if (code == SQLiteErrorCode.SQLITE_READONLY.code) {
            return "it is read only, or its disk is";
        }
        if (code == SQLiteErrorCode.SQLITE_BUSY.code || code == SQLiteErrorCode.SQLITE_LOCKED.code) {
            return "another program locks it";
        }
        if (code == SQLiteErrorCode.SQLITE_IOERR.code) {
            return "its disk does not take it";
        }
        if (code == SQLiteErrorCode.SQLITE_CANTOPEN.code) {
            return "it cannot be opened";
        }
        if (code == SQLiteErrorCode.SQLITE_CORRUPT.code || code == SQLiteErrorCode.SQLITE_NOTADB.code) {
            return "it is damaged";
        }
        return code == 0
                ? String.valueOf(fault.getMessage())
                : "its database refuses to write"; // without a code it is ours
    }

    /** SQLite's write-ahead log of a file. */
    static Path log(Path file) {
        return file.resolveSibling(file.getFileName() + "-wal");
    }

    /** SQLite's index of that log, which all who use it share. */
    static Path index(Path file) {
        return file.resolveSibling(file.getFileName() + "-shm");
    }

    /** Makes the file, and SQLite's files next to it, readable by their user only. */
    void restrict() {
        PrivateFiles.restrictFile(file);
        PrivateFiles.restrictFile(log(file));
        PrivateFiles.restrictFile(index(file));
    }

    /** How many pages of the log are not folded into the file. */
    int pagesInLog() throws SQLException {
        try (Statement statement = connection.createStatement();
                ResultSet log = statement.executeQuery("PRAGMA wal_checkpoint(NOOP)")) {
            return log.next() ? log.getInt(2) - log.getInt(3) : 0;
        }
    }

    /** Folds of the log what is committed, while others read and write. */
    void checkpointPassive() throws SQLException {
        run("PRAGMA wal_checkpoint(PASSIVE)");
    }

    /** Folds the log into the file; what cannot be folded stays in the log. */
    void checkpoint() throws SQLException {
        run("PRAGMA wal_checkpoint(TRUNCATE)");
    }

    /** Folds the log into the file and forces that to the disk: what the disk refused is written again. */
    void rewriteLog() throws SQLException {
        try (Statement statement = connection.createStatement();
                ResultSet result = statement.executeQuery("PRAGMA wal_checkpoint(FULL)")) {
            if (!result.next() || result.getInt(1) != 0 || result.getInt(2) != result.getInt(3)) {
                throw new SQLException("another program reads it, so it cannot be rewritten yet");
            }
        }
    }

    /** Undoes a transaction that failed, where SQLite has not done it itself. */
    void rollBack() {
        try {
            run("ROLLBACK");
        } catch (SQLException none) {
            System.getLogger(Database.class.getName())
                    .log(System.Logger.Level.DEBUG, "nothing to roll back: {0}", none.getMessage());
        }
    }

    /** How large the file is with what is in the log. */
    long bytes() throws SQLException {
        return number("PRAGMA page_count") * number("PRAGMA page_size");
    }

    /** Lets the file have so many pages at most; what needs more is refused as on a full disk. */
    void limitPages(long pages) throws SQLException {
        run("PRAGMA max_page_count=" + pages);
    }

    void run(String sql) throws SQLException {
        try (Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }

    private String text(String sql) throws SQLException {
        try (Statement statement = connection.createStatement();
                ResultSet rows = statement.executeQuery(sql)) {
            return rows.next() ? rows.getString(1) : "";
        }
    }

    private long number(String sql) throws SQLException {
        try (Statement statement = connection.createStatement();
                ResultSet rows = statement.executeQuery(sql)) {
            return rows.next() ? rows.getLong(1) : 0;
        }
    }

    @Override
    public void close() throws JournalException {
        try {
            connection.close();
        } catch (SQLException fault) {
            throw new JournalException(file, 0, "cannot be closed: " + fault.getMessage(), fault);
        }
    }
}
