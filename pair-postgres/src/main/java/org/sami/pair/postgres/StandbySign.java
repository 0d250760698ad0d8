package org.sami.pair.postgres;

import java.sql.Connection;
import java.sql.SQLException;
import org.sami.journal.postgres.Connections;

/** What the standby's base says of itself, in the database of the base that it stands by for: that it has ended in order, so that the other may go on without it. */
final class StandbySign {
    /** How a replica is called in its connection to the database. */
    static final String NAME = "sami_standby";

    private StandbySign() {}

    static void makeTable(Connection connection) throws SQLException {
        Connections.run(connection, "CREATE SCHEMA pair");
        Connections.run(
                connection,
                "CREATE TABLE pair.standby (only_row boolean PRIMARY KEY DEFAULT true CHECK (only_row),"
                        + " ended timestamptz)");
        Connections.run(connection, "INSERT INTO pair.standby (ended) VALUES (NULL)");
    }

    /** The standby begins to watch, or ends in order. */
    static void write(Connection connection, boolean ended) throws SQLException {
        Connections.run(
                connection,
                ended
                        ? "UPDATE pair.standby SET ended = now()"
                        : "UPDATE pair.standby SET ended = NULL WHERE ended IS NOT NULL");
    }

    /** Whether it has ended in order. */
    static boolean hasEnded(Connection connection) throws SQLException {
        return !Connections.text(connection, "SELECT ended FROM pair.standby").isEmpty();
    }
}
