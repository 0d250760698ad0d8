package org.sami.work.postgres;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.sami.journal.postgres.Connections;
import org.sami.journal.postgres.PostgresAddress;

/** Makes the tables of work, enters work, and compares work that is there with work of who wants to join. In the transaction of the caller. */
final class WorkTables {
    /** The version that this program writes and reads. */
    private static final int CURRENT = 1;

    private static final String NOT_SET = "not set";

    private WorkTables() {}

    /** Makes the schema and its tables, or brings them to the present version; one process at a time. */
    static void make(Connection connection, PostgresAddress address) throws SQLException, WorkException {
        String schema = address.schema();
        Connections.run(connection, "SELECT pg_advisory_xact_lock(hashtext('sami work " + schema + "'))");
        if (isThere(connection, schema, "schema_version")) {
            throw new WorkException(
                    address.words()
                            + " holds the journal of a session; name another schema in the address, such as"
                            + " schema=runs",
                    null);
        }
        if (!isThere(connection, schema, "work_version")) {
            if (Connections.text(connection, "SELECT 1 FROM pg_namespace WHERE nspname = '" + schema + "'")
                    .isEmpty()) {
                Connections.run(connection, "CREATE SCHEMA " + schema);
            }
            Connections.run(
                    connection,
                    "CREATE TABLE work_version (version int PRIMARY KEY, applied timestamptz NOT NULL DEFAULT now())");
        }
        int version =
                Integer.parseInt(Connections.text(connection, "SELECT coalesce(max(version), 0) FROM work_version"));
        if (version > CURRENT) {
            throw new WorkException(
                    address.words() + " has tables of version " + version + "; this program knows " + CURRENT, null);
        }
        for (int next = version + 1; next <= CURRENT; next++) {
            Connections.run(connection, script(next));
            Connections.run(connection, "INSERT INTO work_version(version) VALUES (" + next + ")");
        }
    }

    private static boolean isThere(Connection connection, String schema, String table) throws SQLException {
        return !Connections.text(connection, "SELECT to_regclass('" + schema + "." + table + "')")
                .isEmpty();
    }

    private static String script(int version) {
        try (InputStream text = WorkTables.class.getResourceAsStream("V" + version + ".sql")) {
            if (text == null) {
                throw new IllegalStateException("this program lacks the script V" + version + ".sql");
            }
            return new String(text.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException fault) {
            throw new UncheckedIOException(fault);
        }
    }

    /** Enters the work, unless somebody has: then it must be the same. */
    static void enter(Connection connection, PostgresAddress address, SharedWork work)
            throws SQLException, OtherWorkException {
        if (isNew(connection, work)) {
            insert(connection, work);
            return;
        }
        List<String> differences = differences(stored(connection, work.name()), work.settings());
        if (differences.isEmpty()) {
            int runs = count(connection, work.name());
            if (runs != work.runs()) {
                differences.add("number of runs: " + runs + " there, " + work.runs() + " here");
            }
        }
        if (!differences.isEmpty()) {
            throw new OtherWorkException(address.words(), differences);
        }
    }

    private static boolean isNew(Connection connection, SharedWork work) throws SQLException {
        try (PreparedStatement insert = connection.prepareStatement(
                "INSERT INTO experiments(name, runs) VALUES (?, ?) ON CONFLICT DO NOTHING")) {
            insert.setString(1, work.name());
            insert.setInt(2, work.runs());
            return insert.executeUpdate() == 1;
        }
    }

    private static void insert(Connection connection, SharedWork work) throws SQLException {
        try (PreparedStatement insert = connection.prepareStatement("INSERT INTO settings VALUES (?, ?, ?)")) {
            for (Map.Entry<String, String> one : work.settings().entrySet()) {
                insert.setString(1, work.name());
                insert.setString(2, one.getKey());
                insert.setString(3, one.getValue());
                insert.addBatch();
            }
            insert.executeBatch();
        }
        try (PreparedStatement insert = connection.prepareStatement(
                "INSERT INTO runs(experiment, run) SELECT ?, number FROM generate_series(0, ?) AS number")) {
            insert.setString(1, work.name());
            insert.setInt(2, work.runs() - 1);
            insert.executeUpdate();
        }
    }

    private static Map<String, String> stored(Connection connection, String name) throws SQLException {
        Map<String, String> found = new LinkedHashMap<>();
        try (PreparedStatement select =
                connection.prepareStatement("SELECT name, value FROM settings WHERE experiment = ? ORDER BY name")) {
            select.setString(1, name);
            try (ResultSet rows = select.executeQuery()) {
                while (rows.next()) {
                    found.put(rows.getString(1), rows.getString(2));
                }
            }
        }
        return found;
    }

    private static int count(Connection connection, String name) throws SQLException {
        try (PreparedStatement select = connection.prepareStatement("SELECT runs FROM experiments WHERE name = ?")) {
            select.setString(1, name);
            try (ResultSet rows = select.executeQuery()) {
                rows.next();
                return rows.getInt(1);
            }
        }
    }

    private static List<String> differences(Map<String, String> there, Map<String, String> here) {
        Set<String> names = new TreeSet<>(there.keySet());
        names.addAll(here.keySet());
        List<String> differences = new ArrayList<>();
        for (String name : names) {
            String other = there.getOrDefault(name, NOT_SET);
            String own = here.getOrDefault(name, NOT_SET);
            if (!own.equals(other)) {
                differences.add(name + ": " + other + " there, " + own + " here");
            }
        }
        return differences;
    }
}
