package org.sami.journal.postgres;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The other sessions in the database of a pair. A replica becomes the database for all sessions at once, so it must not while one of them goes on at the other base. A session goes on while the row of
 * its lease changes, as {@link LeaseObservation} judges it.
 */
final class OtherSessions {
    private static final long LOOK_NANOS = 500_000_000;

    private final PostgresAddress address;
    private final Duration length;
    private final Map<String, Seen> sessions = new HashMap<>();
    private Optional<Long> lookedNanos = Optional.empty();

    /**
     * A row of a lease.
     *
     * @param sinceNanos when the row was first seen as it is now
     */
    private record Seen(String row, long sinceNanos) {}

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
     * Looks at them, twice a second at most, and names one that goes on.
     *
     * @param nowNanos a clock that does not jump
     * @return its schema; empty where all were given back, or stand still for longer than a lease lasts
     */
    Optional<String> live(Connection connection, long nowNanos) throws SQLException {
        if (lookedNanos.isEmpty() || nowNanos - lookedNanos.get() >= LOOK_NANOS) {
            lookedNanos = Optional.of(nowNanos);
            look(connection, nowNanos);
        }
        return sessions.entrySet().stream()
                .filter(session -> nowNanos - session.getValue().sinceNanos() < length.toNanos())
                .map(Map.Entry::getKey)
                .findFirst();
    }

    private void look(Connection connection, long nowNanos) throws SQLException {
        Map<String, Seen> now = new HashMap<>();
        for (String schema : schemas(connection)) {
            try (Statement statement = connection.createStatement();
                    ResultSet rows = statement.executeQuery(
                            "SELECT epoch || ' ' || ends::text FROM " + statement.enquoteIdentifier(schema, true)
                                    + ".lease WHERE epoch > 0 AND isfinite(ends)")) {
                if (rows.next()) {
                    String row = rows.getString(1);
                    Seen before = sessions.get(schema);
                    now.put(schema, before != null && before.row().equals(row) ? before : new Seen(row, nowNanos));
                }
            }
        }
        sessions.clear();
        sessions.putAll(now);
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
