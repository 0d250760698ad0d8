package org.sami.spn.journal;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Writes entries into a file: many a statement, because a statement's own cost is that of several rows (docs/decisions 0030).
 */
final class EntryTable implements AutoCloseable {
    private static final int COLUMNS = 4;
    private static final String ROW = "(?,?,?,?)";
    /** Rows of the statements there are, from many to one: 1,000 entries are 14 statements. */
    private static final int[] ROWS = {128, 32, 4, 1};

    private final Connection connection;
    private final @Nullable PreparedStatement[] statements = new PreparedStatement[ROWS.length];

    EntryTable(Connection connection) {
        this.connection = connection;
    }

    void write(List<RowWriter.EntryRow> entries) throws SQLException {
        int next = 0;
        for (int width = 0; width < ROWS.length; width++) {
            int rows = ROWS[width];
            while (entries.size() - next >= rows) {
                PreparedStatement insert = statement(width);
                for (int row = 0; row < rows; row++) {
                    bind(insert, row * COLUMNS, entries.get(next + row));
                }
                insert.executeUpdate();
                next += rows;
            }
        }
    }

    /** Most sessions never have so many inputs at once that they need the long ones. */
    private PreparedStatement statement(int width) throws SQLException {
        PreparedStatement known = statements[width];
        if (known != null) {
            return known;
        }
        PreparedStatement made =
                connection.prepareStatement("INSERT INTO entries VALUES " + ROW + ("," + ROW).repeat(ROWS[width] - 1));
        statements[width] = made;
        return made;
    }

    private static void bind(PreparedStatement insert, int offset, RowWriter.EntryRow entry) throws SQLException {
        insert.setLong(offset + 1, entry.index());
        insert.setLong(offset + 2, entry.atMillis());
        insert.setString(offset + 3, entry.input());
        insert.setBytes(offset + 4, entry.checksum().bytes());
    }

    /** Closes its statements; they are made again when needed. So also after one failed: the driver has closed it. */
    @Override
    public void close() throws SQLException {
        for (int width = 0; width < ROWS.length; width++) {
            PreparedStatement made = statements[width];
            statements[width] = null;
            if (made != null) {
                made.close();
            }
        }
    }
}
