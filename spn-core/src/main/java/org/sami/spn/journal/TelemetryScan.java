package org.sami.spn.journal;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads the telemetry of a file that may be damaged: around pages that cannot be read, and without rows whose checksums do
 * not hold. Rows of before checksums were written are believed where their times can be true.
 */
final class TelemetryScan {
    /** Telemetry of several threads is not quite in order of time; no more than this out of it. */
    private static final long DISORDER_MILLIS = 60_000;

    /** No page holds more rows: behind a page that cannot be read this many are tried one after another. */
    private static final int LONGEST_STEP = 64;

    /** After so many steps without a row the rest is given up: the table's inner pages are damaged. */
    private static final int MOST_STEPS = 2000;

    private final Connection connection;
    private final Sums sums;
    private final List<TelemetryRow> rows = new ArrayList<>();
    private final List<Long> positions = new ArrayList<>();
    private final List<Boolean> summed = new ArrayList<>();
    private final Map<String, String> names = new HashMap<>();
    private long damaged;
    private boolean sumsBegan;
    private Optional<String> unreadable = Optional.empty();
    private long at;

    /** Of a file, all of it. */
    TelemetryScan(Database database) {
        this(database, 0);
    }

    /** Of a file, from a row on. */
    TelemetryScan(Database database, long first) {
        this(
                database.connection(),
                () -> new SumsOfTable(database.hasTelemetrySums(), database.hasAllTelemetrySums()),
                first);
    }

    /** Of a database whose rows all have checksums, from a row on. */
    TelemetryScan(Connection connection, long first) {
        this(connection, () -> new SumsOfTable(true, true), first);
    }

    private TelemetryScan(Connection connection, Sums sums, long first) {
        this.connection = connection;
        this.sums = sums;
        this.at = first;
    }

    /** What a table says of the checksums of its rows. */
    private record SumsOfTable(boolean some, boolean all) {}

    @FunctionalInterface
    private interface Sums {
        SumsOfTable find() throws SQLException;
    }

    /** What is true of the file's telemetry. */
    Telemetry run() {
        try {
            SumsOfTable found = sums.find();
            sumsBegan = found.all();
            long step = 1;
            int steps = 0;
            while (steps < MOST_STEPS && !readOn(found.some())) {
                boolean gotOn = !positions.isEmpty() && positions.get(positions.size() - 1) >= at;
                steps = gotOn ? 0 : steps + 1;
                step = gotOn ? 1 : Math.min(LONGEST_STEP, step * 2);
                at = (gotOn ? positions.get(positions.size() - 1) + 1 : at) + step;
            }
        } catch (SQLException fault) {
            unreadable = Optional.of(String.valueOf(fault.getMessage()));
        }
        if (!positions.isEmpty()) {
            at = positions.get(positions.size() - 1) + 1;
        }
        dropImpossibleTimes();
        return new Telemetry(rows, damage());
    }

    /** Where the rows behind those that {@link #run} has read begin. */
    long next() {
        return at;
    }

    /** Reads from a position to the end; false if something on the way cannot be read. */
    private boolean readOn(boolean hasSums) {
        String sql = "SELECT pos, at_millis, proxy, kind, json, " + (hasSums ? "sum" : "NULL")
                + " FROM telemetry WHERE pos >= ? ORDER BY pos";
        try (PreparedStatement select = connection.prepareStatement(sql)) {
            select.setLong(1, at);
            try (ResultSet found = select.executeQuery()) {
                while (found.next()) {
                    take(found);
                }
            }
            return true;
        } catch (SQLException fault) {
            unreadable = Optional.of(String.valueOf(fault.getMessage()));
            return false;
        }
    }

    private void take(ResultSet found) throws SQLException {
        long position = found.getLong(1);
        if (!positions.isEmpty() && position <= positions.get(positions.size() - 1)) {
            damaged++; // the same page twice, or one of another table
            return;
        }
        String proxy = found.getString(3);
        String kind = found.getString(4);
        String json = found.getString(5);
        long sum = found.getLong(6);
        boolean hasSum = !found.wasNull();
        if (proxy == null || kind == null || json == null || (sumsBegan && !hasSum)) {
            damaged++;
            return;
        }
        TelemetryRow row = new TelemetryRow(found.getLong(2), once(proxy), once(kind), json);
        if (hasSum && TelemetryTable.sum(row) != sum) {
            damaged++;
            return;
        }
        sumsBegan |= hasSum;
        rows.add(row);
        positions.add(position);
        summed.add(hasSum);
    }

    /** Rows are kept in memory, and many have the same few names. */
    private String once(String name) {
        return names.computeIfAbsent(name, first -> first);
    }

    /** Without a checksum, a row that is later than those after it did not happen then. */
    private void dropImpossibleTimes() {
        long earliestAfter = Long.MAX_VALUE - DISORDER_MILLIS;
        for (int i = rows.size() - 1; i >= 0; i--) {
            long millis = rows.get(i).atMillis();
            if (!summed.get(i) && (millis < 0 || millis > earliestAfter + DISORDER_MILLIS)) {
                rows.remove(i);
                damaged++;
            } else {
                earliestAfter = Math.min(earliestAfter, millis);
            }
        }
    }

    private Optional<String> damage() {
        List<String> words = new ArrayList<>();
        if (damaged > 0) {
            words.add(damaged + (damaged == 1 ? " row is" : " rows are") + " damaged");
        }
        unreadable.ifPresent(why -> words.add("some rows cannot be read (" + why + ")"));
        return words.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        "telemetry: " + String.join(", ", words) + " and left out; " + rows.size() + " rows are whole");
    }
}
