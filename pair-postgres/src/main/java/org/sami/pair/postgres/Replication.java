package org.sami.pair.postgres;

import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.Optional;
import org.sami.journal.postgres.Connections;

/** What a database of a pair says of itself, and the one thing that is changed while it runs: whether it waits for its standby. */
final class Replication {
    /** The setting that says which database a replica follows. */
    static final String SOURCE = "primary_conninfo";

    private Replication() {}

    /** Whether the database is a replica. */
    static boolean isReplica(Connection connection) throws SQLException {
        return isTrue(Connections.text(connection, "SELECT pg_is_in_recovery()"));
    }

    private static boolean isTrue(String text) {
        return text.equals("t");
    }

    /** Counts how often a replica became the database before it was this one. Not of a replica. */
    static int timeline(Connection connection) throws SQLException {
        return Integer.parseInt(
                Connections.text(connection, "SELECT substr(pg_walfile_name(pg_current_wal_lsn()), 1, 8)"), 16);
    }

    /** Whether it confirms nothing before its standby has it. */
    static boolean waitsForStandby(Connection connection) throws SQLException {
        return !Connections.text(connection, "SHOW synchronous_standby_names").isEmpty();
    }

    /** Has it wait for its standby from now on, or no longer; whoever waits at this moment goes on then. */
    static void setWaitsForStandby(Connection connection, boolean waits) throws SQLException {
        Connections.run(
                connection, "ALTER SYSTEM SET synchronous_standby_names = '" + (waits ? StandbySign.NAME : "") + "'");
        Connections.run(connection, "SELECT pg_reload_conf()");
    }

    /** How its standby follows, and whether a base waits there to go on with a session. */
    static StandbyState standby(Connection connection, String session) throws SQLException {
        boolean ended = StandbySign.hasEnded(connection);
        boolean watched = StandbySign.isThere(connection, session);
        return new StandbyState(replica(connection), watched, ended);
    }

    /** How its replica follows. */
    static ReplicaState replica(Connection connection) throws SQLException {
        try (Statement statement = connection.createStatement();
                ResultSet rows = statement.executeQuery(
                        "SELECT state = 'streaming', coalesce(pg_wal_lsn_diff(pg_current_wal_lsn(), replay_lsn), 0)"
                                + " FROM pg_stat_replication WHERE application_name = '" + StandbySign.NAME + "'"
                                + " ORDER BY backend_start DESC LIMIT 1")) {
            return rows.next()
                    ? new ReplicaState(true, rows.getBoolean(1), rows.getLong(2))
                    : new ReplicaState(false, false, 0);
        }
    }

    /** Whether a replica gets entries from the database that it follows. */
    static boolean isFollowing(Connection replica) throws SQLException {
        return isTrue(Connections.text(replica, "SELECT bool_or(status = 'streaming') FROM pg_stat_wal_receiver"));
    }

    /**
     * Has a replica follow the database at another address, from what it has on.
     *
     * @param admin a connection of {@link Roles#ADMIN}
     * @param source in the words of {@link PairConnections#sourceOfReplica}
     */
    static void follow(Connection admin, String source) throws SQLException {
        Connections.run(admin, "ALTER SYSTEM SET " + SOURCE + " = '" + source.replace("'", "''") + "'");
        Connections.run(admin, "SELECT pg_reload_conf()");
    }

    /** When the last change that a replica has was made, by the clock of the database that it follows, and how long ago that is by this one's; empty where there is none. */
    static Optional<String> lastReceived(Connection replica) throws SQLException {
        String text = Connections.text(
                replica,
                "SELECT to_char(pg_last_xact_replay_timestamp(), 'HH24:MI:SS') || ', ' || round(extract(epoch FROM"
                        + " clock_timestamp() - pg_last_xact_replay_timestamp())) || ' s ago'");
        return text.isEmpty() ? Optional.empty() : Optional.of(text);
    }

    /** Has a replica become the database, and waits until it is. */
    static void promote(Connection replica, int seconds) throws SQLException {
        if (!isTrue(Connections.text(replica, "SELECT pg_promote(true, " + seconds + ")"))) {
            throw new SQLException("the replica did not become the database within " + seconds + " s");
        }
    }
}
