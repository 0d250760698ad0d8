package org.sami.spn.journal;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.NavigableMap;
import java.util.NavigableSet;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import org.sami.spn.host.JournalException;

/**
 * Reads a whole file once and finds out how far it is true. Nothing that SQLite says is believed without a checksum: of
 * damage in its own pages it reports some, and gives the rest back as data.
 */
final class Scan {
    private final String where;
    private final Connection connection;
    private final HashChain chain = new HashChain();
    private final ProjectDocuments documents;
    private final NavigableMap<Long, Checksum> snapshots = new TreeMap<>();
    private final NavigableMap<Long, Checksum> marks = new TreeMap<>();
    private NavigableSet<Long> snapshotIndexes = new TreeSet<>();
    private NavigableSet<Long> markIndexes = new TreeSet<>();
    private long last;
    private long lastMillis;
    private Checksum checksum = new Checksum(0, 0);
    private Optional<String> damage = Optional.empty();

    private Scan(String where, Connection connection) {
        this.where = where;
        this.connection = connection;
        this.documents = new ProjectDocuments(connection);
    }

    /**
     * What is true in the file.
     *
     * @throws JournalException where not even the header is
     */
    static Contents of(String where, Connection connection) throws JournalException {
        return new Scan(where, connection).run();
    }

    /**
     * What is true in the file by now, of which a part was read before: only what is behind that is read.
     *
     * @param known what was read before
     * @return empty where that is not in the file any more
     */
    static Optional<Contents> on(String where, Connection connection, Contents known) throws JournalException {
        return new Scan(where, connection).goOn(known);
    }

    private Optional<Contents> goOn(Contents known) throws JournalException {
        last = known.lastValid();
        lastMillis = known.lastMillis();
        checksum = known.lastChecksum();
        if (!isThere(known)) {
            return Optional.empty();
        }
        snapshots.putAll(known.snapshots());
        marks.putAll(known.marks());
        snapshotIndexes = indexes("snapshots");
        markIndexes = indexes("marks");
        remember();
        entries();
        return Optional.of(new Contents(known.header(), last, lastMillis, checksum, snapshots, marks, damage));
    }

    private boolean isThere(Contents known) throws JournalException {
        if (last == 0) {
            return HeaderTable.read(where, connection).checksum().equals(checksum);
        }
        try (PreparedStatement select = connection.prepareStatement("SELECT checksum FROM entries WHERE idx = ?")) {
            select.setLong(1, last);
            try (ResultSet row = select.executeQuery()) {
                return row.next() && known.lastChecksum().is(bytes(row, 1));
            }
        } catch (SQLException fault) {
            throw new JournalException(where, last, "cannot be read: " + fault.getMessage(), fault);
        }
    }

    private Contents run() throws JournalException {
        HeaderTable.Read header = HeaderTable.read(where, connection);
        checksum = header.checksum();
        snapshotIndexes = indexes("snapshots");
        markIndexes = indexes("marks");
        remember();
        entries();
        return new Contents(header.header(), last, lastMillis, checksum, snapshots, marks, damage);
    }

    private void entries() {
        try (PreparedStatement select = connection.prepareStatement(
                "SELECT idx, at_millis, input, checksum FROM entries WHERE idx > ? ORDER BY idx")) {
            select.setLong(1, last == 0 ? Long.MIN_VALUE : last); // an index below 1 is damage as well
            try (ResultSet rows = select.executeQuery()) {
                while (rows.next()) {
                    if (!follows(rows.getLong(1), rows.getLong(2), bytes(rows, 3), bytes(rows, 4))) {
                        return;
                    }
                }
            }
        } catch (SQLException fault) {
            note("entry " + (last + 1) + " cannot be read: " + fault.getMessage());
        }
    }

    private boolean follows(long index, long atMillis, byte[] input, byte[] stored) {
        if (index != last + 1) {
            note("entry " + (last + 1) + " is missing, entry " + index + " is there");
            return false;
        }
        Checksum expected = chain.entry(checksum, index, atMillis, input);
        if (!expected.is(stored)) {
            note("entry " + index + " is damaged: its checksum does not hold");
            return false;
        }
        Optional<String> document = InputText.documentOf(input);
        if (document.isPresent() && documents.find(document.get()).isEmpty()) {
            note("entry " + index + " is damaged: the document of the project that it loads does not hold");
            return false;
        }
        last = index;
        lastMillis = atMillis;
        checksum = expected;
        remember();
        return true;
    }

    private void remember() {
        if (snapshotIndexes.contains(last)) {
            snapshots.put(last, checksum);
        }
        if (markIndexes.contains(last)) {
            marks.put(last, checksum);
        }
    }

    private NavigableSet<Long> indexes(String table) {
        NavigableSet<Long> indexes = new TreeSet<>();
        try (PreparedStatement select = connection.prepareStatement("SELECT idx FROM " + table + " WHERE idx >= ?")) {
            select.setLong(1, last);
            try (ResultSet rows = select.executeQuery()) {
                while (rows.next()) {
                    indexes.add(rows.getLong(1));
                }
            }
        } catch (SQLException fault) {
            note("the " + table + " cannot be read: " + fault.getMessage());
        }
        return indexes;
    }

    private void note(String what) {
        damage = Optional.of(damage.map(before -> before + "; " + what).orElse(what));
    }

    static byte[] bytes(ResultSet row, int column) throws SQLException {
        byte[] value = row.getBytes(column);
        return value == null ? new byte[0] : value;
    }
}
