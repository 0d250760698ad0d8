package org.sami.pair.postgres;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import org.sami.journal.postgres.Connections;

/**
 * The rows by which standbys report themselves in the database of the base that holds their sessions: for each session when its standby was last there, and for the pair whether the last of
 * them has ended in order, so that the database need not wait for its replica.
 */
final class StandbySign {
    /** The name of a replica in its connection to the database. */
    static final String NAME = "sami_standby";

    /** A standby reports every two seconds; after this many seconds without a report it counts as gone. */
    private static final String THERE = "seen > clock_timestamp() - interval '8 s'";

    private StandbySign() {}

    static void makeTable(Connection connection) throws SQLException {
        Connections.run(connection, "CREATE SCHEMA pair");
        Connections.run(
                connection,
                "CREATE TABLE pair.standby (only_row boolean PRIMARY KEY DEFAULT true CHECK (only_row),"
                        + " ended timestamptz)");
        Connections.run(connection, "INSERT INTO pair.standby (ended) VALUES (NULL)");
        completeTable(connection);
    }

    /** Adds what pairs of an earlier program lack. */
    static void completeTable(Connection connection) throws SQLException {
        Connections.run(
                connection,
                "CREATE TABLE IF NOT EXISTS pair.session_standby (session text PRIMARY KEY, seen timestamptz)");
    }

    /** Reports that the standby of a session is there. */
    static void writePresence(Connection connection, String session) throws SQLException {
        // In one transaction: a standby that is there while the pair's last has ended would not be waited for.
        run(
                connection,
                "WITH awaited AS (UPDATE pair.standby SET ended = NULL)"
                        + " INSERT INTO pair.session_standby VALUES (?, clock_timestamp())"
                        + " ON CONFLICT (session) DO UPDATE SET seen = excluded.seen",
                session);
    }

    /** Reports that the standby of a session has ended in order. The database goes on waiting for its replica where the standby of another session is there. */
    static void writeEnd(Connection connection, String session) throws SQLException {
        // One statement after the other: of two standbys that end at once, the second to look sees that both have.
        run(connection, "UPDATE pair.session_standby SET seen = NULL WHERE session = ?", session);
        Connections.run(
                connection,
                "UPDATE pair.standby SET ended = now()" + " WHERE NOT EXISTS (SELECT FROM pair.session_standby WHERE "
                        + THERE + ")");
    }

    /** Has the database not wait for its replica before a standby reports itself again. */
    static void writeEndOfAll(Connection connection) throws SQLException {
        Connections.run(connection, "UPDATE pair.standby SET ended = now()");
    }

    /** Whether the standby of a session is there: its last report is at most eight seconds old, by the clock of the database that has it. */
    static boolean isThere(Connection connection, String session) throws SQLException {
        try (PreparedStatement asked =
                connection.prepareStatement("SELECT FROM pair.session_standby WHERE session = ? AND " + THERE)) {
            asked.setString(1, session);
            try (ResultSet rows = asked.executeQuery()) {
                return rows.next();
            }
        }
    }

    /** Whether the last standby of the pair has ended in order. */
    static boolean hasEnded(Connection connection) throws SQLException {
        return !Connections.text(connection, "SELECT ended FROM pair.standby").isEmpty();
    }

    /** The sessions whose standby is there, by name, with commas; empty text where there is none. */
    static String sessions(Connection connection) throws SQLException {
        return Connections.text(
                connection,
                "SELECT string_agg(session, ', ' ORDER BY session) FROM pair.session_standby WHERE " + THERE);
    }

    private static void run(Connection connection, String sql, String session) throws SQLException {
        try (PreparedStatement statement = connection.prepareStatement(sql)) {
            statement.setString(1, session);
            statement.execute();
        }
    }
}
