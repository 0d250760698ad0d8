package org.sami.spn.journal;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.protocol.Input;

/**
 * Documents of the projects that were loaded during the session, by their SHA-256: an equal document is stored once
 * (docs/session.md). In a file the table is made with the first of them; that of a session that loads nothing has none.
 */
final class ProjectDocuments {
    private static final String TABLE =
            "CREATE TABLE IF NOT EXISTS documents (sha256 TEXT PRIMARY KEY, content TEXT NOT NULL) STRICT";

    private final Connection connection;

    ProjectDocuments(Connection connection) {
        this.connection = connection;
    }

    /** Makes the table in a file, within the transaction of the caller. */
    void makeTable() throws SQLException {
        try (Statement statement = connection.createStatement()) {
            statement.execute(TABLE);
        }
    }

    /** Adds a document, within the transaction of the caller. */
    void add(Input.LoadProject load) throws SQLException {
        // A copy that was damaged since is replaced.
        try (PreparedStatement insert = connection.prepareStatement(
                "INSERT INTO documents VALUES (?, ?) ON CONFLICT (sha256) DO UPDATE SET content = excluded.content")) {
            insert.setString(1, load.sha256());
            insert.setString(2, load.document());
            insert.executeUpdate();
        }
    }

    /** The document with that SHA-256; empty where it is not there or not what it was. */
    Optional<String> find(String sha256) {
        try (PreparedStatement select = connection.prepareStatement("SELECT content FROM documents WHERE sha256 = ?")) {
            select.setString(1, sha256);
            try (ResultSet rows = select.executeQuery()) {
                return rows.next()
                        ? Optional.ofNullable(rows.getString(1)).filter(content -> isOf(content, sha256))
                        : Optional.empty();
            }
        } catch (SQLException damagedOrNoTable) {
            return Optional.empty();
        }
    }

    /**
     * All documents that are what they were, by their SHA-256; none where there is no table.
     *
     * @throws SQLException where they cannot be read
     */
    Map<String, String> all() throws SQLException {
        Map<String, String> all = new LinkedHashMap<>();
        if (!hasTable()) { // asked first, as a query that fails would end a transaction
            return all;
        }
        try (PreparedStatement select = connection.prepareStatement("SELECT sha256, content FROM documents");
                ResultSet rows = select.executeQuery()) {
            while (rows.next()) {
                String sha256 = rows.getString(1);
                String content = rows.getString(2);
                if (sha256 != null && content != null && isOf(content, sha256)) {
                    all.put(sha256, content);
                }
            }
        }
        return all;
    }

    /** Whether the journal's own schema has the table; a file has no schemas. */
    private boolean hasTable() throws SQLException {
        Optional<String> schema = Optional.ofNullable(connection.getSchema()).filter(name -> !name.isEmpty());
        try (ResultSet tables = connection.getMetaData().getTables(null, null, "documents", new String[] {"TABLE"})) {
            while (tables.next()) {
                String its = tables.getString("TABLE_SCHEM");
                if (schema.isEmpty() || schema.get().equals(its)) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean isOf(String document, String sha256) {
        return new Input.LoadProject(document).sha256().equals(sha256);
    }
}
