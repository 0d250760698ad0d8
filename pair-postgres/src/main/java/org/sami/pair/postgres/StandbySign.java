package org.sami.pair.postgres;

import java.sql.Connection;
import java.sql.SQLException;
import org.sami.journal.postgres.Connections;

/** What the standby's base says of itself, in the database of the base that it stands by for: when it was there last, and that it has ended in order, so that the other may go on without it. */
final class StandbySign {
    /** How a replica is called in its connection to the database. */
    static final String NAME = "sami_standby";

    /** A base that stands by says so every two seconds. */
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

    /** The standby begins to watch, or ends in order. */
    static void write(Connection connection, boolean ended) throws SQLException {
        Connections.run(
                connection,
                ended
                        ? "UPDATE pair.standby SET ended = now()"
                        : "UPDATE pair.standby SET ended = NULL, seen = clock_timestamp()");
    }

    /** Whether a base stands by: it has said so within the last seconds, by the clock of the database to which it says it. */
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
