package org.sami.journal.postgres;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * The row that says who may write, by the database's clock alone. Its epoch only grows: with each holder by one. Whoever appends locks the row's key in the transaction of the append; whoever
 * takes over changes the key. So a take-over waits for appends under way, and an append behind it finds no row of its epoch.
 */
final class LeaseTable {
    /** How a lease stands. */
    enum Standing {
        HELD,
        /** Nobody else has taken it. */
        ENDED,
        SUPERSEDED
    }

    /**
     * Who holds it.
     *
     * @param left how long it lasts still; not positive where it is over
     * @param ends when it is over, by the database's clock
     * @param since when it was taken, for people
     */
    record Holder(long epoch, String name, Duration left, String ends, String since) {
        /** For people. */
        String words() {
            return name + " since " + since + " (epoch " + epoch + ")";
        }
    }

    private LeaseTable() {}

    /** Takes the lease where it is over; gives its epoch. */
    static OptionalLong take(Connection connection, String holder, Duration length) throws SQLException {
        try (PreparedStatement update = connection.prepareStatement(
                "WITH now AS (SELECT clock_timestamp() AS t), taken AS (UPDATE lease SET epoch = epoch + 1, holder = ?, taken = now.t,"
                        + " ends = now.t + ? * interval '1 ms' FROM now WHERE ends <= now.t RETURNING epoch, holder, taken)"
                        + " INSERT INTO holders SELECT epoch, holder, taken FROM taken RETURNING epoch")) {
            update.setString(1, holder);
            update.setLong(2, length.toMillis());
            try (ResultSet rows = update.executeQuery()) {
                return rows.next() ? OptionalLong.of(rows.getLong(1)) : OptionalLong.empty();
            }
        }
    }

    /** Lets it last longer, also where it was over and nobody has taken it; false if somebody has. */
    static boolean renew(Connection connection, long epoch, Duration length) throws SQLException {
        try (PreparedStatement update = connection.prepareStatement(
                "UPDATE lease SET ends = clock_timestamp() + ? * interval '1 ms' WHERE epoch = ?")) {
            update.setLong(1, length.toMillis());
            update.setLong(2, epoch);
            return update.executeUpdate() == 1;
        }
    }

    /** How the lease of an epoch stands; it stays so until the transaction ends. */
    static Standing lock(Connection connection, long epoch) throws SQLException {
        try (PreparedStatement select = connection.prepareStatement(
                "SELECT ends > clock_timestamp() FROM lease WHERE epoch = ? FOR KEY SHARE")) {
            select.setLong(1, epoch);
            try (ResultSet rows = select.executeQuery()) {
                if (!rows.next()) {
                    return Standing.SUPERSEDED;
                }
                return rows.getBoolean(1) ? Standing.HELD : Standing.ENDED;
            }
        }
    }

    /** Ends it now. */
    static void release(Connection connection, long epoch) throws SQLException {
        try (PreparedStatement update =
                connection.prepareStatement("UPDATE lease SET ends = clock_timestamp() WHERE epoch = ?")) {
            update.setLong(1, epoch);
            update.executeUpdate();
        }
    }

    /** Who has it, or had it last; empty where nobody ever had. */
    static Optional<Holder> holder(Connection connection) throws SQLException {
        try (PreparedStatement select = connection.prepareStatement(
                        "SELECT epoch, holder, round(1000 * extract(epoch FROM ends - clock_timestamp())),"
                                + " ends::text, to_char(taken, 'HH24:MI:SS') FROM lease WHERE epoch > 0");
                ResultSet rows = select.executeQuery()) {
            return rows.next()
                    ? Optional.of(new Holder(
                            rows.getLong(1),
                            rows.getString(2),
                            Duration.ofMillis(rows.getLong(3)),
                            rows.getString(4),
                            rows.getString(5)))
                    : Optional.empty();
        }
    }
}
