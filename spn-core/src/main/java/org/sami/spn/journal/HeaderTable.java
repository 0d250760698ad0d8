package org.sami.spn.journal;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.host.JournalException;

/** Reads and writes the header; its checksum is the table's last row and the beginning of the entries' chain. */
final class HeaderTable {
    private static final String FORMAT = "format";
    private static final String PROJECT = "project";
    private static final String VOCABULARY = "vocabulary";
    private static final String SETTING = "setting";
    private static final String CHECKSUM = "checksum";

    private HeaderTable() {}

    /** Writes it and gives its checksum. */
    static Checksum write(Connection connection, JournalHeader header) throws SQLException {
        List<Row> rows = rows(header);
        Checksum checksum = checksum(rows);
        rows.add(new Row(CHECKSUM, "", checksum.hex()));
        try (PreparedStatement insert =
                connection.prepareStatement("INSERT INTO header(kind, name, content) VALUES (?, ?, ?)")) {
            for (Row row : rows) {
                insert.setString(1, row.kind);
                insert.setString(2, row.name);
                insert.setString(3, row.content);
                insert.executeUpdate();
            }
        }
        return checksum;
    }

    /** Reads it; refuses whatever is not exactly as it was written. */
    static Read read(String where, Connection connection) throws JournalException {
        List<Row> rows = new ArrayList<>();
        try (Statement statement = connection.createStatement();
                ResultSet found = statement.executeQuery("SELECT kind, name, content FROM header ORDER BY pos")) {
            while (found.next()) {
                rows.add(new Row(text(found, 1), text(found, 2), text(found, 3)));
            }
        } catch (SQLException damage) {
            throw new JournalException(where, 0, "cannot be read: " + damage.getMessage(), damage);
        }
        if (rows.isEmpty()) {
            throw new JournalException(where, 0, "is missing");
        }
        Row last = rows.remove(rows.size() - 1);
        Checksum checksum = checksum(rows);
        if (!last.kind.equals(CHECKSUM) || !last.content.equals(checksum.hex())) {
            throw new JournalException(where, 0, "is damaged: its checksum does not hold");
        }
        return new Read(header(where, rows), checksum);
    }

    private static String text(ResultSet row, int column) throws SQLException {
        String value = row.getString(column);
        return value == null ? "" : value;
    }

    private static List<Row> rows(JournalHeader header) {
        List<Row> rows = new ArrayList<>();
        rows.add(new Row(FORMAT, "", Integer.toString(header.formatVersion())));
        rows.add(new Row(PROJECT, "", header.project()));
        header.vocabulary().forEach((name, text) -> rows.add(new Row(VOCABULARY, name, text)));
        header.settings().forEach((name, text) -> rows.add(new Row(SETTING, name, text)));
        return rows;
    }

    private static JournalHeader header(String where, List<Row> rows) throws JournalException {
        String project = "";
        int version = 0;
        Map<String, String> vocabulary = new LinkedHashMap<>();
        Map<String, String> settings = new LinkedHashMap<>();
        for (Row row : rows) {
            switch (row.kind) {
                case FORMAT -> version = Integer.parseInt(row.content);
                case PROJECT -> project = row.content;
                case VOCABULARY -> vocabulary.put(row.name, row.content);
                case SETTING -> settings.put(row.name, row.content);
                default -> throw new JournalException(where, 0, "has a part of unknown kind: " + row.kind);
            }
        }
        if (version != JournalHeader.CURRENT_VERSION) {
            throw new JournalException(
                    where,
                    0,
                    "has format version " + version + "; this program reads " + JournalHeader.CURRENT_VERSION);
        }
        return new JournalHeader(version, project, vocabulary, settings);
    }

    private static Checksum checksum(List<Row> rows) {
        return new HashChain()
                .header(rows.stream()
                        .flatMap(row -> Arrays.stream(new String[] {row.kind, row.name, row.content}))
                        .toList());
    }

    /** The header with its checksum. */
    record Read(JournalHeader header, Checksum checksum) {}

    private record Row(String kind, String name, String content) {}
}
