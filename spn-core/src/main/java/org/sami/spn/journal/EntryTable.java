package org.sami.spn.journal;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.util.List;

/**
 * Writes entries into a file: many a statement, because a statement's own cost is several times that of a row (docs/decisions 0030).
 */
final class EntryTable implements AutoCloseable {
    private static final int COLUMNS = 4;
    private static final int MANY = 32;

    private final Connection connection;
    private PreparedStatement one;
    private PreparedStatement many;

    EntryTable(Connection connection) throws SQLException {
        this.connection = connection;
        prepare();
    }

    private void prepare() throws SQLException {
        one = connection.prepareStatement("INSERT INTO entries VALUES (?,?,?,?)");
        many = connection.prepareStatement("INSERT INTO entries VALUES (?,?,?,?)" + ",(?,?,?,?)".repeat(MANY - 1));
    }

    void write(List<RowWriter.EntryRow> entries) throws SQLException {
        int next = 0;
        while (next < entries.size()) {
            boolean wide = entries.size() - next >= MANY;
            PreparedStatement insert = wide ? many : one;
            int rows = wide ? MANY : 1;
            for (int row = 0; row < rows; row++) {
                bind(insert, row * COLUMNS, entries.get(next + row));
            }
            insert.executeUpdate();
            next += rows;
        }
    }

    private static void bind(PreparedStatement insert, int offset, RowWriter.EntryRow entry) throws SQLException {
        insert.setLong(offset + 1, entry.index());
        insert.setLong(offset + 2, entry.atMillis());
        insert.setString(offset + 3, entry.input());
        insert.setBytes(offset + 4, entry.checksum().bytes());
    }

    /** Goes on after a statement failed: the driver has closed it. */
    void renew() throws SQLException {
        close();
        prepare();
    }

    @Override
    public void close() throws SQLException {
        one.close();
        many.close();
    }
}
