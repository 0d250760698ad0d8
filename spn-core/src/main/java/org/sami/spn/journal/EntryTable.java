package org.sami.spn.journal;

import java.nio.charset.StandardCharsets;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.List;
import org.sami.spn.host.JournalEntry;

/**
 * Writes entries: many a statement, because a statement's own cost is several times that of a row (docs/decisions 0030).
 */
final class EntryTable implements AutoCloseable {
    private static final int COLUMNS = 4;
    private static final int MANY = 32;

    private final Connection connection;
    private final HashChain chain = new HashChain();
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

    /** Writes entries, which the caller commits; gives the chain's new end. */
    Checksum write(List<JournalEntry> entries, Checksum previous) throws SQLException {
        Checksum checksum = previous;
        int next = 0;
        while (next < entries.size()) {
            boolean wide = entries.size() - next >= MANY;
            PreparedStatement insert = wide ? many : one;
            int rows = wide ? MANY : 1;
            for (int row = 0; row < rows; row++) {
                checksum = bind(insert, row * COLUMNS, entries.get(next + row), checksum);
            }
            insert.executeUpdate();
            next += rows;
        }
        return checksum;
    }

    private Checksum bind(PreparedStatement insert, int offset, JournalEntry entry, Checksum previous)
            throws SQLException {
        String input = InputText.write(entry.input());
        byte[] bytes = input.getBytes(StandardCharsets.UTF_8);
        Checksum checksum = chain.entry(previous, entry.index(), entry.atMillis(), bytes);
        insert.setLong(offset + 1, entry.index());
        insert.setLong(offset + 2, entry.atMillis());
        insert.setString(offset + 3, input);
        insert.setBytes(offset + 4, checksum.bytes());
        return checksum;
    }

    /** Goes on after a statement failed: the driver has closed it. */
    void renew() throws SQLException {
        close();
        prepare();
    }

    /** Whether the file's last entry is this one; an index of 0 says that it has none. */
    boolean endsWith(long index, Checksum checksum) throws SQLException {
        try (Statement statement = connection.createStatement();
                ResultSet last =
                        statement.executeQuery("SELECT idx, checksum FROM entries ORDER BY idx DESC LIMIT 1")) {
            return last.next() ? last.getLong(1) == index && checksum.is(Scan.bytes(last, 2)) : index == 0;
        }
    }

    @Override
    public void close() throws SQLException {
        one.close();
        many.close();
    }
}
