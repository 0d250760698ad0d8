package org.sami.journal.postgres;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * The other sessions in the database of a pair. A replica becomes the database for all sessions at once, so it must not while one of them goes on at the other base, or may. {@link OtherLease} judges
 * each.
 */
final class OtherSessions {
    private static final long LOOK_NANOS = 500_000_000;

    private final PostgresAddress address;
    private final Duration length;
    private final Map<String, OtherLease> sessions = new TreeMap<>();
    private Optional<Long> lookedNanos = Optional.empty();

    /**
     * Those beside the session of an address.
     *
     * @param length how long a lease lasts
     */
    OtherSessions(PostgresAddress address, Duration length) {
        this.address = address;
        this.length = length;
    }

    /**
     * Looks at them, twice a second at most, and names one that is not over.
     *
     * @param follows whether the replica is of now
     * @param nowNanos a clock that does not jump
     * @return what it does, for people; empty where all are over
     */
    Optional<String> live(Connection connection, boolean follows, long nowNanos) throws SQLException {
        sessions.values().forEach(session -> session.follow(follows, nowNanos));
        if (lookedNanos.isEmpty() || nowNanos - lookedNanos.get() >= LOOK_NANOS) {
            lookedNanos = Optional.of(nowNanos);
            look(connection, follows, nowNanos);
        }
        return sessions.entrySet().stream()
                .filter(session -> !session.getValue().isOver())
                .map(session -> "the session " + session.getKey() + " of this pair "
                        + (session.getValue().isFresh(nowNanos) ? "goes on" : "may go on") + " at the other base")
                .findFirst();
    }

    /** Forgets what was seen: the machine slept or the database did not answer, and what stood still meanwhile may go on. */
    void forget() {
        sessions.clear();
        lookedNanos = Optional.empty();
    }

    private void look(Connection connection, boolean follows, long nowNanos) throws SQLException {
        List<String> schemas = schemas(connection);
        sessions.keySet().retainAll(schemas);
        for (String schema : schemas) {
            Optional<OtherLease.Row> row = row(connection, schema);
            if (row.isEmpty()) {
                sessions.remove(schema);
            } else {
                OtherLease session = sessions.computeIfAbsent(schema, unknown -> new OtherLease(length));
                session.follow(follows, nowNanos);
                session.look(row.get(), nowNanos);
            }
        }
    }

    private static Optional<OtherLease.Row> row(Connection connection, String schema) throws SQLException {
        try (Statement statement = connection.createStatement();
                ResultSet rows = statement.executeQuery("SELECT epoch, ends::text, NOT isfinite(ends), standby_may_take"
                        + " FROM " + statement.enquoteIdentifier(schema, true) + ".lease WHERE epoch > 0")) {
            return rows.next()
                    ? Optional.of(new OtherLease.Row(
                            rows.getLong(1), rows.getString(2), rows.getBoolean(3), rows.getBoolean(4)))
                    : Optional.empty();
        }
    }

    private List<String> schemas(Connection connection) throws SQLException {
        List<String> schemas = new ArrayList<>();
        try (PreparedStatement select = connection.prepareStatement(
                "SELECT schemaname FROM pg_tables WHERE tablename = 'lease' AND schemaname <> ? ORDER BY schemaname")) {
            select.setString(1, address.schema());
            try (ResultSet rows = select.executeQuery()) {
                while (rows.next()) {
                    schemas.add(rows.getString(1));
                }
            }
        }
        return schemas;
    }
}
