package org.sami.spn.journal;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.zip.CRC32C;

/**
 * Telemetry on its way into the file: taken from any thread, written with whatever is committed next. Each row carries a
 * checksum of its own, and none of its predecessor's: a row that is lost spoils no other.
 */
final class TelemetryTable {
    /** A disk that is full for long must not fill the memory as well: about a hundred megabytes. */
    private static final int MOST_WAITING = 200_000;

    private final ConcurrentLinkedQueue<TelemetryRow> waiting = new ConcurrentLinkedQueue<>();
    private final AtomicInteger count = new AtomicInteger(); // of those that wait
    private final AtomicLong lost = new AtomicLong();
    private final List<TelemetryRow> uncommitted = new ArrayList<>(); // for who writes the journal

    /** Takes rows; where too many wait already they are counted and let go. */
    void add(List<TelemetryRow> rows) {
        if (count.get() + rows.size() > MOST_WAITING) {
            lost.addAndGet(rows.size());
            return;
        }
        count.addAndGet(rows.size());
        waiting.addAll(rows);
    }

    boolean isEmpty() {
        return waiting.isEmpty() && uncommitted.isEmpty();
    }

    /** How many rows were let go. */
    long lost() {
        return lost.get();
    }

    /** Writes what waits; the caller commits, and says so by {@link #committed}, else it is written again the next time. */
    void write(RowWriter writer) throws SQLException {
        for (TelemetryRow row = waiting.poll(); row != null; row = waiting.poll()) {
            uncommitted.add(row);
        }
        if (!uncommitted.isEmpty()) {
            writer.telemetry(uncommitted.stream()
                    .map(row -> new RowWriter.SummedTelemetry(row, sum(row)))
                    .toList());
        }
    }

    /** What was written is in the file. */
    void committed() {
        count.addAndGet(-uncommitted.size());
        uncommitted.clear();
    }

    static PreparedStatement insertion(Connection connection) throws SQLException {
        return connection.prepareStatement(
                "INSERT INTO telemetry(at_millis, proxy, kind, json, sum) VALUES (?, ?, ?, ?, ?)");
    }

    static void insert(PreparedStatement insert, TelemetryRow row) throws SQLException {
        insert(insert, row, sum(row));
    }

    static void insert(PreparedStatement insert, TelemetryRow row, long sum) throws SQLException {
        insert.setLong(1, row.atMillis());
        insert.setString(2, row.proxy());
        insert.setString(3, row.kind());
        insert.setString(4, row.json());
        insert.setLong(5, sum);
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
}
