package org.sami.spn.journal;

import java.lang.System.Logger.Level;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;

/** Telemetry on its way into the file: taken from any thread, written with whatever is committed next. */
final class TelemetryTable {
    private final ConcurrentLinkedQueue<TelemetryRow> waiting = new ConcurrentLinkedQueue<>();

    void add(List<TelemetryRow> rows) {
        waiting.addAll(rows);
    }

    boolean isEmpty() {
        return waiting.isEmpty();
    }

    /** Writes what waits; the caller commits. */
    void write(Connection connection) throws SQLException {
        if (waiting.isEmpty()) {
            return;
        }
        try (PreparedStatement insert = connection.prepareStatement(
                "INSERT INTO telemetry(at_millis, proxy, kind, json) VALUES (?, ?, ?, ?)")) {
            for (TelemetryRow row = waiting.poll(); row != null; row = waiting.poll()) {
                insert(insert, row);
            }
        }
    }

    static void insert(PreparedStatement insert, TelemetryRow row) throws SQLException {
        insert.setLong(1, row.atMillis());
        insert.setString(2, row.proxy());
        insert.setString(3, row.kind());
        insert.setString(4, row.json());
        insert.executeUpdate();
    }

    /** The rows up to the first that cannot be read, in the order in which they were added. */
    static List<TelemetryRow> readable(Connection connection) {
        List<TelemetryRow> found = new ArrayList<>();
        try (Statement statement = connection.createStatement();
                ResultSet rows =
                        statement.executeQuery("SELECT at_millis, proxy, kind, json FROM telemetry ORDER BY pos")) {
            while (rows.next()) {
                String json = rows.getString(4);
                if (rows.getString(2) != null && rows.getString(3) != null && json != null) {
                    found.add(new TelemetryRow(rows.getLong(1), rows.getString(2), rows.getString(3), json));
                }
            }
        } catch (SQLException damaged) {
            System.getLogger(TelemetryTable.class.getName())
                    .log(Level.WARNING, "telemetry ends after {0} rows: {1}", found.size(), damaged.getMessage());
        }
        return found;
    }
}
