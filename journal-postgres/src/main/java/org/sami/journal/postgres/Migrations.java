package org.sami.journal.postgres;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.sql.Connection;
import java.sql.SQLException;
import org.sami.spn.host.JournalException;

/**
 * The versions of a journal's schema: numbered scripts, each run once, in the transaction of the caller. A library for it would be larger than the module that it serves (docs/decisions
 * 0493).
 */
final class Migrations {
    /** The version that this program writes and reads. */
    static final int CURRENT = 2;

    private Migrations() {}

    /** Whether the schema has the tables of a journal. */
    static boolean isThere(Connection connection, PostgresAddress address) throws SQLException {
        return !Connections.text(connection, "SELECT to_regclass('" + address.schema() + ".schema_version')")
                .isEmpty();
    }

    /** Makes the schema and its tables, or brings them to the present version; one process at a time. */
    static void run(Connection connection, PostgresAddress address) throws SQLException, JournalException {
        String schema = address.schema();
        Connections.run(connection, "SELECT pg_advisory_xact_lock(hashtext('sami journal " + schema + "'))");
        if (!isThere(connection, address)) {
            checkEncoding(connection, address);
            if (Connections.text(connection, "SELECT 1 FROM pg_namespace WHERE nspname = '" + schema + "'")
                    .isEmpty()) {
                Connections.run(connection, "CREATE SCHEMA " + schema);
            }
            Connections.run(
                    connection,
                    "CREATE TABLE schema_version (version int PRIMARY KEY, applied timestamptz NOT NULL DEFAULT"
                            + " now())");
        }
        for (int next = version(connection, address) + 1; next <= CURRENT; next++) {
            Connections.run(connection, script(next));
            Connections.run(connection, "INSERT INTO schema_version(version) VALUES (" + next + ")");
        }
    }

    /** Refuses a schema of a later program. */
    static int version(Connection connection, PostgresAddress address) throws SQLException, JournalException {
        int version =
                Integer.parseInt(Connections.text(connection, "SELECT coalesce(max(version), 0) FROM schema_version"));
        if (version > CURRENT) {
            throw new JournalException(
                    address.words(), 0, "has schema version " + version + "; this program knows " + CURRENT);
        }
        return version;
    }

    private static void checkEncoding(Connection connection, PostgresAddress address)
            throws SQLException, JournalException {
        String encoding = Connections.text(connection, "SHOW server_encoding");
        if (!encoding.equals("UTF8")) {
            throw new JournalException(
                    address.words(), 0, "is a database of encoding " + encoding + "; a journal needs UTF8");
        }
    }

    private static String script(int version) {
        try (InputStream text = Migrations.class.getResourceAsStream("V" + version + ".sql")) {
            if (text == null) {
                throw new IllegalStateException("this program lacks the script V" + version + ".sql");
            }
            return new String(text.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException fault) {
            throw new UncheckedIOException(fault);
        }
    }
}
