package org.sami.journal.postgres;

import java.sql.Connection;
import java.sql.SQLException;
import java.util.Optional;

/** Takes a session from the base that holds it and leaves it to the standby, on the order of a person. */
public final class TakeOver {
    private static final int ANSWER_SECONDS = 8;

    private TakeOver() {}

    /**
     * Takes the lease of a journal from its holder, which stops commanding with its next renewal, and leaves it to the base that waits. Where the database has a standby that it waits for,
     * returns once the standby has all of it.
     *
     * @return who held it, for people; empty where nobody did, so that a base that waits goes on anyway
     * @throws SQLException if the database is not reached, or does not allow it
     */
    public static Optional<String> takeAway(PostgresAddress address) throws SQLException {
        return taken(address, LeaseTable::takeAway);
    }

    /** The same in a database of a pair that was a replica: a base that has gone on there since keeps the session. */
    public static Optional<String> takeFromOtherDatabase(PostgresAddress address) throws SQLException {
        return taken(address, LeaseTable::takeFromOtherDatabase);
    }

    private static Optional<String> taken(PostgresAddress address, Taking taking) throws SQLException {
        try (Connection connection = Connections.toRenew(address, ANSWER_SECONDS)) {
            return Migrations.isThere(connection, address)
                    ? taking.take(connection, "crw take-over of " + ProcessName.ofThisProcess())
                            .map(LeaseTable.Holder::words)
                    : Optional.empty();
        }
    }

    @FunctionalInterface
    private interface Taking {
        Optional<LeaseTable.Holder> take(Connection connection, String by) throws SQLException;
    }

    /**
     * Whether a base that held the journal in the other database of a pair did not give it away, and this database, which was a replica, was promoted without a base that goes on with it. Not of a
     * replica.
     */
    public static boolean isLeftByOtherDatabase(PostgresAddress address) throws SQLException {
        try (Connection connection = Connections.toRenew(address, ANSWER_SECONDS)) {
            return Migrations.isThere(connection, address) && LeaseTable.isOfOtherDatabase(connection);
        }
    }

    /** Who holds a journal, for people; empty where nobody does, by what the database knows. */
    public static Optional<String> holder(PostgresAddress address) throws SQLException {
        try (Connection connection = Connections.toRenew(address, ANSWER_SECONDS)) {
            return Migrations.isThere(connection, address)
                    ? LeaseTable.holder(connection)
                            .filter(holder -> !holder.isGivenBack())
                            .map(LeaseTable.Holder::words)
                    : Optional.empty();
        }
    }
}
