package org.sami.spn.journal;

import java.nio.charset.StandardCharsets;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.List;
import java.util.Optional;

/** Snapshots and marks: each is bound by its checksum to the entry that it follows. */
final class Attachments {
    private static final String SNAPSHOT = "snapshot";
    private static final String MARK = "mark";

    private final Connection connection;
    private final HashChain chain = new HashChain();

    Attachments(Connection connection) {
        this.connection = connection;
    }

    void writeSnapshot(long index, Checksum entryChecksum, byte[] state) throws SQLException {
        try (PreparedStatement insert = connection.prepareStatement(
                "INSERT INTO snapshots VALUES (?, ?, ?) ON CONFLICT (idx) DO UPDATE SET state = excluded.state,"
                        + " checksum = excluded.checksum")) {
            insert.setLong(1, index);
            insert.setBytes(2, state);
            insert.setBytes(3, chain.attached(entryChecksum, SNAPSHOT, state).bytes());
            insert.executeUpdate();
        }
    }

    void dropSnapshots(List<Long> indexes) throws SQLException {
        try (PreparedStatement delete = connection.prepareStatement("DELETE FROM snapshots WHERE idx = ?")) {
            for (long index : indexes) {
                delete.setLong(1, index);
                delete.executeUpdate();
            }
        }
    }

    void writeMark(long index, Checksum entryChecksum, String text) throws SQLException {
        try (PreparedStatement insert = connection.prepareStatement(
                "INSERT INTO marks VALUES (?, ?, ?) ON CONFLICT (idx) DO UPDATE SET mark = excluded.mark,"
                        + " checksum = excluded.checksum")) {
            insert.setLong(1, index);
            insert.setString(2, text);
            insert.setBytes(
                    3,
                    chain.attached(entryChecksum, MARK, text.getBytes(StandardCharsets.UTF_8))
                            .bytes());
            insert.executeUpdate();
        }
    }

    /** The state after an entry; empty where the snapshot is not there any more or its checksum does not hold. */
    Optional<byte[]> snapshot(long index, Checksum entryChecksum) {
        try (PreparedStatement select =
                connection.prepareStatement("SELECT state, checksum FROM snapshots WHERE idx = ?")) {
            select.setLong(1, index);
            return checked(select, entryChecksum, SNAPSHOT);
        } catch (SQLException damaged) {
            return Optional.empty(); // the entries say the same, more slowly
        }
    }

    /** The mark after an entry; empty where it cannot be read or its checksum does not hold. */
    Optional<String> mark(long index, Checksum entryChecksum) {
        try (PreparedStatement select = connection.prepareStatement("SELECT mark, checksum FROM marks WHERE idx = ?")) {
            select.setLong(1, index);
            return checked(select, entryChecksum, MARK).map(text -> new String(text, StandardCharsets.UTF_8));
        } catch (SQLException damaged) {
            return Optional.empty();
        }
    }

    private Optional<byte[]> checked(PreparedStatement select, Checksum entryChecksum, String kind)
            throws SQLException {
        try (ResultSet rows = select.executeQuery()) {
            if (!rows.next()) {
                return Optional.empty();
            }
            byte[] content = Scan.bytes(rows, 1);
            boolean holds = chain.attached(entryChecksum, kind, content).is(Scan.bytes(rows, 2));
            return holds ? Optional.of(content) : Optional.empty();
        }
    }
}
