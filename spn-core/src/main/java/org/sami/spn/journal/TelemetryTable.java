package org.sami.spn.journal;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.zip.CRC32C;

/**
 * Telemetry on its way into the file: taken from any thread, written with whatever is committed next. Each row carries a
 * checksum of its own, and none of its predecessor's: a row that is lost spoils no other.
 */
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
        try (PreparedStatement insert = insertion(connection)) {
            for (TelemetryRow row = waiting.poll(); row != null; row = waiting.poll()) {
                insert(insert, row);
            }
        }
    }

    static PreparedStatement insertion(Connection connection) throws SQLException {
        return connection.prepareStatement(
                "INSERT INTO telemetry(at_millis, proxy, kind, json, sum) VALUES (?, ?, ?, ?, ?)");
    }

    static void insert(PreparedStatement insert, TelemetryRow row) throws SQLException {
        insert.setLong(1, row.atMillis());
        insert.setString(2, row.proxy());
        insert.setString(3, row.kind());
        insert.setString(4, row.json());
        insert.setLong(5, sum(row));
        insert.executeUpdate();
    }

    /** CRC-32C over a row, each text led by its length in bytes. */
    static long sum(TelemetryRow row) {
        CRC32C sum = new CRC32C();
        sum.update(ByteBuffer.allocate(Long.BYTES).putLong(row.atMillis()).flip());
        for (String text : List.of(row.proxy(), row.kind(), row.json())) {
            byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
            sum.update(ByteBuffer.allocate(Integer.BYTES).putInt(bytes.length).flip());
            sum.update(bytes);
        }
        return sum.getValue();
    }

    /** What is true of a file's telemetry. */
    static Telemetry read(Database database) {
        return new TelemetryScan(database).run();
    }
}
