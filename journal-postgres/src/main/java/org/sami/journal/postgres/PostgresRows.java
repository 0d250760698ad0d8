package org.sami.journal.postgres;

import java.sql.Array;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.util.List;
import org.sami.spn.journal.RowWriter;
import org.sami.spn.journal.TelemetryRow;

/** Writes the rows of a batch by one statement: each would cost a way to the database and back. */
final class PostgresRows implements RowWriter {
    private static final String NUL = "\u0000";

    private final Connection connection;

    PostgresRows(Connection connection) {
        this.connection = connection;
    }

    @Override
    public void entries(List<EntryRow> rows) throws SQLException {
        try (PreparedStatement insert = connection.prepareStatement(
                "INSERT INTO entries SELECT * FROM unnest(?::bigint[], ?::bigint[], ?::text[], ?::bytea[])")) {
            insert.setArray(
                    1, array("bigint", rows.stream().map(EntryRow::index).toArray()));
            insert.setArray(
                    2, array("bigint", rows.stream().map(EntryRow::atMillis).toArray()));
            insert.setArray(3, array("text", rows.stream().map(EntryRow::input).toArray()));
            insert.setArray(
                    4,
                    array(
                            "bytea",
                            rows.stream().map(row -> row.checksum().bytes()).toArray(byte[][]::new)));
            insert.executeUpdate();
        }
    }

    private Array array(String type, Object[] values) throws SQLException {
        return connection.createArrayOf(type, values);
    }

    /** PostgreSQL has no text with a NUL in it, which only a broken robot names itself by: such a row is left out. */
    @Override
    public void telemetry(List<SummedTelemetry> rows) throws SQLException {
        try (PreparedStatement insert = connection.prepareStatement(
                "INSERT INTO telemetry(at_millis, proxy, kind, json, sum) VALUES (?, ?, ?, ?, ?)")) {
            for (SummedTelemetry summed : rows) {
                TelemetryRow row = summed.row();
                if (!(row.proxy() + row.kind() + row.json()).contains(NUL)) {
                    insert.setLong(1, row.atMillis());
                    insert.setString(2, row.proxy());
                    insert.setString(3, row.kind());
                    insert.setString(4, row.json());
                    insert.setLong(5, summed.sum());
                    insert.addBatch();
                }
            }
            insert.executeBatch();
        }
    }
}
