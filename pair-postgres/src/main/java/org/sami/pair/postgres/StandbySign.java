package org.sami.pair.postgres;

import java.sql.Connection;
import java.sql.SQLException;
import org.sami.journal.postgres.Connections;

/** The row by which a standby reports itself in the database of the base that holds the session: when it was last there, and whether it has ended in order, so that the holder may go on without it. */
final class StandbySign {
    /** The name of a replica in its connection to the database. */
    static final String NAME = "sami_standby";

    /** A standby reports every two seconds; after this many seconds without a report it counts as gone. */
    private static final int SILENT_SECONDS = 8;

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
        Connections.run(connection, "ALTER TABLE pair.standby ADD COLUMN IF NOT EXISTS seen timestamptz");
    }

    /** Reports that the standby is there, or that it has ended in order. */
    static void write(Connection connection, boolean ended) throws SQLException {
        Connections.run(
                connection,
                ended
                        ? "UPDATE pair.standby SET ended = now()"
                        : "UPDATE pair.standby SET ended = NULL, seen = clock_timestamp()");
    }

    /** Whether a standby is there: its last report is at most eight seconds old, by the clock of the database that has it. */
    static boolean isThere(Connection connection) throws SQLException {
        return Connections.text(
                        connection,
                        "SELECT ended IS NULL AND seen > clock_timestamp() - interval '" + SILENT_SECONDS
                                + " s' FROM pair.standby")
                .equals("t");
    }

    /** Whether it has ended in order. */
    static boolean hasEnded(Connection connection) throws SQLException {
        return !Connections.text(connection, "SELECT ended FROM pair.standby").isEmpty();
    }
}
