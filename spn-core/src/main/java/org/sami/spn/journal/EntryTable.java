package org.sami.spn.journal;

import java.nio.charset.StandardCharsets;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.util.List;
import org.sami.spn.host.JournalEntry;

/**
 * Writes entries: many a statement, because a statement's own cost is several times that of a row (docs/decisions 0030).
 */
final class EntryTable implements AutoCloseable {
    private static final int COLUMNS = 4;
    private static final int MANY = 32;

    private final HashChain chain = new HashChain();
    private final PreparedStatement one;
    private final PreparedStatement many;

    EntryTable(Connection connection) throws SQLException {
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

    @Override
    public void close() throws SQLException {
        one.close();
        many.close();
    }
}
