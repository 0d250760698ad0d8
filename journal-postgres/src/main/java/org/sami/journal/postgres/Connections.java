package org.sami.journal.postgres;

import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.Properties;

/**
 * Opens connections to the database of a journal, or of what else stands at such an address. The driver takes the password from the file that {@code PGPASSFILE} names, else from {@code ~/.pgpass}; it stands in no address.
 */
public final class Connections {
    /** An answer that takes longer is none: a network that was cut says nothing. */
    private static final int WRITER_SECONDS = 10;

    private static final int READER_SECONDS = 120;

    /** Of each second in which an answer must come: a backend whose client has given up is to wait for no lock. */
    private static final int LOCK_MILLIS = 750;

    /** Of a reader that has little to read, and is to find out soon that its network was cut. */
    private static final int FOLLOWER_SECONDS = 4;

    private Connections() {}

    /** For a writer: waits for locks and answers shortly, so that a fault shows while boats can still be held. */
    public static Connection toWrite(PostgresAddress address) throws SQLException {
        Properties properties = properties(address, WRITER_SECONDS);
        properties.setProperty(
                "options",
                "-c lock_timeout=4000 -c statement_timeout=9000 -c idle_in_transaction_session_timeout=9000");
        Connection connection = connect(address, properties);
        try {
            connection.setAutoCommit(false);
            connection.setTransactionIsolation(
                    Connection.TRANSACTION_READ_COMMITTED); // the lease is looked at as it is now
            return connection;
        } catch (SQLException fault) {
            connection.close();
            throw fault;
        }
    }

    /** For the lease alone: an answer must come before the lease ends. Where the database has a standby that it waits for, a lease is renewed once the standby sees it. */
    static Connection toRenew(PostgresAddress address, int seconds) throws SQLException {
        Properties properties = properties(address, seconds);
        properties.setProperty(
                "options", "-c synchronous_commit=remote_apply -c lock_timeout=" + seconds * LOCK_MILLIS);
        return connect(address, properties);
    }

    /** For a reader, which sees the journal as it was when it began. */
    static Connection toRead(PostgresAddress address) throws SQLException {
        return toRead(address, READER_SECONDS);
    }

    /** For a reader who has read most of the journal before. */
    static Connection toFollow(PostgresAddress address) throws SQLException {
        return toRead(address, FOLLOWER_SECONDS);
    }

    private static Connection toRead(PostgresAddress address, int seconds) throws SQLException {
        Properties properties = properties(address, seconds);
        properties.setProperty("readOnly", "true");
        Connection connection = connect(address, properties);
        try {
            connection.setAutoCommit(false); // rows come in portions then
            connection.setTransactionIsolation(Connection.TRANSACTION_REPEATABLE_READ);
            return connection;
        } catch (SQLException fault) {
            connection.close();
            throw fault;
        }
    }

    private static Properties properties(PostgresAddress address, int answerSeconds) {
        Properties properties = address.properties();
        properties.setProperty("ApplicationName", "sami-journal");
        properties.setProperty("connectTimeout", Integer.toString(Math.min(5, answerSeconds)));
        properties.setProperty("socketTimeout", Integer.toString(answerSeconds));
        properties.setProperty("tcpKeepAlive", "true");
        properties.setProperty("defaultRowFetchSize", "500");
        properties.setProperty("reWriteBatchedInserts", "true");
        properties.setProperty("logServerErrorDetail", "false"); // it would hold what rows hold
        return properties;
    }

    private static Connection connect(PostgresAddress address, Properties properties) throws SQLException {
        return DriverManager.getConnection(address.url(), properties);
    }

    /** Runs a statement. */
    public static void run(Connection connection, String sql) throws SQLException {
        try (Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }

    /** The first column of the first row; empty text where there is none. */
    public static String text(Connection connection, String sql) throws SQLException {
        try (Statement statement = connection.createStatement();
                ResultSet rows = statement.executeQuery(sql)) {
            String found = rows.next() ? rows.getString(1) : null;
            return found == null ? "" : found;
        }
    }

    /** Ends a connection that may answer no longer, without waiting for it. */
    public static void drop(Connection connection) {
        try {
            connection.abort(Runnable::run);
        } catch (SQLException gone) {
            System.getLogger(Connections.class.getName())
                    .log(System.Logger.Level.DEBUG, "dropping a connection: {0}", gone.getMessage());
        }
    }
}
