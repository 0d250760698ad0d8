package org.sami.journal.postgres;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * The row that names the base that may write a journal. Its epoch grows with each holder, and by more where a replica became the database. Appends hold a lock of the database together until
 * their transactions end, and a take-over holds it alone. So a take-over waits for appends under way, and a later append of the old holder finds no row of its epoch. No lock of the row itself
 * would do: PostgreSQL loses one of its key where another transaction, as a renewal is, moves the row to another page meanwhile (docs/decisions 0700). Leases are timed by the clock of the
 * database that all bases ask. Where one database replicates another, so that both have the row, a standby judges it by {@link LeaseObservation}.
 */
final class LeaseTable {
    /** How a lease stands. */
    enum Standing {
        HELD,
        /** The holder still has it: no other base has taken it. */
        ENDED,
        SUPERSEDED
    }

    /**
     * The holder of a lease.
     *
     * @param left how long it lasts still, by the database's clock; not positive where it is over
     * @param ends when it is over, by the clock of the database that wrote it; {@link #GIVEN_BACK} where it was given back
     * @param since when it was taken, for people
     * @param standbyMayTake whether the holder counts on a standby on another machine, which then may go on by itself
     */
    record Holder(long epoch, String name, Duration left, String ends, String since, boolean standbyMayTake) {
        /** For people. */
        String words() {
            return name + " since " + since + " (epoch " + epoch + ")";
        }

        /** Whether its holder gave it back, so that it is over by every clock. */
        boolean isGivenBack() {
            return ends.equals(GIVEN_BACK);
        }
    }

    private static final String GIVEN_BACK = "-infinity";

    /** Locks of other programs have other first numbers; a database has a lease table for each journal. */
    private static final String KEY = "(1396788553, 'lease'::regclass::oid::int4); ";

    /** A statement behind it, of the same transaction, sees what was committed before the lock was got. */
    private static final String WITH_APPENDS = "SELECT pg_advisory_xact_lock_shared" + KEY;

    private static final String ALONE = "SELECT pg_advisory_xact_lock" + KEY;

    /** In the database of a pair: the holder counts on its standby at present, which may go on by itself. */
    private static final String STANDBY_MAY_TAKE = "(current_setting('synchronous_standby_names') <> ''"
            + " AND coalesce(current_setting('" + PairSetting.NAME + "', true), '') = '" + PairSetting.TAKE_OVER
            + "')";

    /**
     * The lowest epoch that is given in the database of a pair as it is now. A replica that became the database has a higher timeline. Its epochs are then higher than any that the other database
     * can still give, however often a base goes on there.
     */
    private static final String FIRST_EPOCH = "(1 + " + PairSetting.EPOCHS_OF_A_TIMELINE
            + " * (('x' || substr(pg_walfile_name(pg_current_wal_lsn()), 1, 8))::bit(32)::bigint - 1))";

    private static final String NEXT_EPOCH = "CASE WHEN coalesce(current_setting('" + PairSetting.NAME
            + "', true), '') = '' THEN epoch + 1 ELSE greatest(epoch + 1, " + FIRST_EPOCH + ") END";

    private LeaseTable() {}

    /** Takes the lease where it is over by the database's clock; gives its epoch. */
    static OptionalLong take(Connection connection, String holder, Duration length) throws SQLException {
        String over = "ends <= now.t";
        if (!mayBeTaken(connection, over)) {
            return OptionalLong.empty();
        }
        try (PreparedStatement update = connection.prepareStatement(taking(over))) {
            update.setString(1, holder);
            update.setLong(2, length.toMillis());
            return epoch(update);
        }
    }

    /** Takes a lease whose row a standby has seen unchanged for longer than the lease lasts, unless somebody has renewed or taken it since; gives its epoch. */
    static OptionalLong takeSeen(Connection connection, String holder, Duration length, Holder seen)
            throws SQLException {
        try (PreparedStatement update = connection.prepareStatement(taking("epoch = ? AND ends = ?::timestamptz"))) {
            update.setString(1, holder);
            update.setLong(2, length.toMillis());
            update.setLong(3, seen.epoch());
            update.setString(4, seen.ends());
            return epoch(update);
        }
    }

    /** Looks before it locks: whoever waits for a lease asks ten times a second, and is to hold up no append. Where nothing can be written, the attempt is to say so. */
    private static boolean mayBeTaken(Connection connection, String condition) throws SQLException {
        return !Connections.text(
                        connection,
                        "SELECT 1 FROM lease, (SELECT clock_timestamp() AS t) AS now WHERE " + condition
                                + " OR pg_is_in_recovery()")
                .isEmpty();
    }

    private static String taking(String condition) {
        return ALONE + "WITH now AS (SELECT clock_timestamp() AS t), taken AS (UPDATE lease SET epoch = " + NEXT_EPOCH
                + ", holder = ?, taken = now.t, ends = now.t + ? * interval '1 ms', standby_may_take = "
                + STANDBY_MAY_TAKE + " FROM now WHERE " + condition + " RETURNING epoch, holder, taken)"
                + " INSERT INTO holders SELECT epoch, holder, taken FROM taken RETURNING epoch";
    }

    private static OptionalLong epoch(PreparedStatement update) throws SQLException {
        try (ResultSet rows = behindLock(update)) {
            return rows.next() ? OptionalLong.of(rows.getLong(1)) : OptionalLong.empty();
        }
    }

    /** What the statement behind the one that locks gives; both go to the database at once, in one transaction also where the connection commits by itself. */
    private static ResultSet behindLock(PreparedStatement both) throws SQLException {
        both.execute();
        both.getMoreResults();
        return both.getResultSet();
    }

    /** Renews the lease, also where it was over and no other base has taken it; false if another base has. */
    static boolean renew(Connection connection, long epoch, Duration length) throws SQLException {
        try (PreparedStatement update =
                connection.prepareStatement("UPDATE lease SET ends = clock_timestamp() + ? * interval '1 ms',"
                        + " standby_may_take = " + STANDBY_MAY_TAKE + " WHERE epoch = ?")) {
            update.setLong(1, length.toMillis());
            update.setLong(2, epoch);
            return update.executeUpdate() == 1;
        }
    }

    /** How the lease of an epoch stands; nobody takes it until the transaction ends. */
    static Standing lock(Connection connection, long epoch) throws SQLException {
        try (PreparedStatement select = connection.prepareStatement(
                WITH_APPENDS + "SELECT ends > clock_timestamp() FROM lease WHERE epoch = ?")) {
            select.setLong(1, epoch);
            try (ResultSet rows = behindLock(select)) {
                if (!rows.next()) {
                    return Standing.SUPERSEDED;
                }
                return rows.getBoolean(1) ? Standing.HELD : Standing.ENDED;
            }
        }
    }

    /** Gives the lease back: it is over at once, by every clock. */
    static void release(Connection connection, long epoch) throws SQLException {
        try (PreparedStatement update =
                connection.prepareStatement("UPDATE lease SET ends = '" + GIVEN_BACK + "' WHERE epoch = ?")) {
            update.setLong(1, epoch);
            update.executeUpdate();
        }
    }

    /**
     * Takes the lease from its holder and leaves it to the base that waits. The holder learns of it by its next renewal or append.
     *
     * @param by who does it, as the replaced base is told
     * @return who held it; empty where nobody did
     */
    static Optional<Holder> takeAway(Connection connection, String by) throws SQLException {
        return takeAway(connection, by, "true");
    }

    /** The same, only from a base that took it in the other database of a pair: one that has gone on here keeps it. */
    static Optional<Holder> takeFromOtherDatabase(Connection connection, String by) throws SQLException {
        return takeAway(connection, by, "epoch < " + FIRST_EPOCH);
    }

    private static Optional<Holder> takeAway(Connection connection, String by, String condition) throws SQLException {
        Optional<Holder> holder = holder(connection);
        if (holder.isEmpty() || holder.get().isGivenBack()) {
            return Optional.empty();
        }
        try (PreparedStatement update = connection.prepareStatement(ALONE
                + "WITH taken AS (UPDATE lease SET epoch = epoch + 1, holder = ?, taken = clock_timestamp(), ends = '"
                + GIVEN_BACK + "' WHERE epoch = ? AND " + condition + " RETURNING epoch, holder, taken)"
                + " INSERT INTO holders SELECT epoch, holder, taken FROM taken RETURNING epoch")) {
            update.setString(1, by);
            update.setLong(2, holder.get().epoch());
            return epoch(update).isPresent() ? holder : Optional.empty();
        }
    }

    /**
     * Whether the lease was taken in the other database of a pair and is not given back: this one was its replica then, and nobody has gone on with the session here since. Not of a replica.
     */
    static boolean isOfOtherDatabase(Connection connection) throws SQLException {
        return Connections.text(
                        connection, "SELECT epoch < " + FIRST_EPOCH + " AND isfinite(ends) FROM lease WHERE epoch > 0")
                .equals("t");
    }

    /** Who has it, or had it last; empty where nobody ever had. */
    static Optional<Holder> holder(Connection connection) throws SQLException {
        try (PreparedStatement select = connection.prepareStatement("SELECT epoch, holder, CASE WHEN isfinite(ends)"
                        + " THEN round(1000 * extract(epoch FROM ends - clock_timestamp())) ELSE 0 END,"
                        + " ends::text, to_char(taken, 'HH24:MI:SS'), standby_may_take FROM lease WHERE epoch > 0");
                ResultSet rows = select.executeQuery()) {
            return rows.next()
                    ? Optional.of(new Holder(
                            rows.getLong(1),
                            rows.getString(2),
                            Duration.ofMillis(rows.getLong(3)),
                            rows.getString(4),
                            rows.getString(5),
                            rows.getBoolean(6)))
                    : Optional.empty();
        }
    }
}
