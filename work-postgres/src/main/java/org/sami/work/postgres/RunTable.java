package org.sami.work.postgres;

import java.sql.Array;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.TreeMap;
import org.sami.journal.postgres.Connections;

/**
 * The rows of runs and workers. By the database's clock alone a lease is over. Each call is part of the caller's transaction.
 *
 * @param work its name
 * @param leaseMillis how long a run stays its worker's without a renewal
 */
record RunTable(String work, long leaseMillis) {
    /** How often a run may end its worker: the first end may be anybody's fault. */
    static final int MOST_BEGUN = 2;

    /** Leases after which a run whose worker says nothing is given up: one that stands still for some seconds is not dead. */
    private static final int SILENT_LEASES = 5;

    private static final String FREE = "result IS NULL AND ends <= clock_timestamp()";
    private static final String LEASE = "clock_timestamp() + ? * interval '1 ms'";

    /** Enters a worker and gives its number. */
    long join(Connection connection, String name) throws SQLException {
        try (PreparedStatement insert = connection.prepareStatement(
                "INSERT INTO workers(experiment, name, ends) VALUES (?, ?, " + LEASE + ") RETURNING id")) {
            insert.setString(1, work);
            insert.setString(2, name);
            insert.setLong(3, leaseMillis);
            try (ResultSet rows = insert.executeQuery()) {
                rows.next();
                return rows.getLong(1);
            }
        }
    }

    /** Takes the first free run; empty where none is. Several workers ask at once without waiting for one another. */
    OptionalInt take(Connection connection, long worker) throws SQLException {
        try (PreparedStatement update =
                connection.prepareStatement("UPDATE runs SET worker = ?, begun = begun + 1, ends = "
                        + LEASE
                        + " WHERE experiment = ? AND run = (SELECT run FROM runs WHERE experiment = ? AND begun < "
                        + MOST_BEGUN + " AND " + FREE
                        + " ORDER BY run LIMIT 1 FOR UPDATE SKIP LOCKED) RETURNING run")) {
            update.setLong(1, worker);
            update.setLong(2, leaseMillis);
            update.setString(3, work);
            update.setString(4, work);
            try (ResultSet rows = update.executeQuery()) {
                return rows.next() ? OptionalInt.of(rows.getInt(1)) : OptionalInt.empty();
            }
        }
    }

    /** Keeps a result. The first counts: a worker that was thought dead comes to the same one. */
    void done(Connection connection, long worker, int run, String result) throws SQLException {
        try (PreparedStatement update = connection.prepareStatement(
                "UPDATE runs SET worker = ?, result = ? WHERE experiment = ? AND run = ? AND result IS NULL")) {
            update.setLong(1, worker);
            update.setString(2, result.replace('\0', ' ')); // which no text of PostgreSQL can hold
            update.setString(3, work);
            update.setInt(4, run);
            update.executeUpdate();
        }
    }

    /**
     * Frees runs of a worker that has not made them.
     *
     * @param counts whether they ended it
     */
    void free(Connection connection, long worker, Collection<Integer> runs, boolean counts) throws SQLException {
        String begun = counts ? "" : ", begun = begun - 1";
        update(connection, worker, runs, "SET ends = '-infinity'" + begun);
    }

    /** Lets the leases of a worker and of its runs last longer. */
    void renew(Connection connection, long worker, Collection<Integer> runs) throws SQLException {
        String later = "SET ends = clock_timestamp() + interval '" + leaseMillis + " ms'";
        Connections.run(connection, "UPDATE workers " + later + " WHERE id = " + worker);
        update(connection, worker, runs, later);
    }

    /** The worker is gone. */
    void leave(Connection connection, long worker) throws SQLException {
        Connections.run(connection, "UPDATE workers SET ends = clock_timestamp() WHERE id = " + worker);
    }

    private void update(Connection connection, long worker, Collection<Integer> runs, String change)
            throws SQLException {
        try (PreparedStatement update = connection.prepareStatement("UPDATE runs " + change
                + " WHERE experiment = ? AND worker = ? AND result IS NULL AND run = ANY (?)")) {
            Array numbers = connection.createArrayOf("int4", runs.toArray(new Integer[0]));
            update.setString(1, work);
            update.setLong(2, worker);
            update.setArray(3, numbers);
            update.executeUpdate();
        }
    }

    /** What came of the runs that are done, by their numbers. */
    Map<Integer, String> results(Connection connection) throws SQLException {
        Map<Integer, String> results = new TreeMap<>();
        try (PreparedStatement select = connection.prepareStatement(
                "SELECT run, result FROM runs WHERE experiment = ? AND result IS NOT NULL")) {
            select.setString(1, work);
            try (ResultSet rows = select.executeQuery()) {
                while (rows.next()) {
                    results.put(rows.getInt(1), rows.getString(2));
                }
            }
        }
        return results;
    }

    /** How far it is. */
    Standing standing(Connection connection) throws SQLException {
        int[] counts = new int[3];
        try (PreparedStatement select = connection.prepareStatement(
                "SELECT count(*), count(result), count(*) FILTER (WHERE result IS NULL AND ends > clock_timestamp())"
                        + " FROM runs WHERE experiment = ?")) {
            select.setString(1, work);
            try (ResultSet rows = select.executeQuery()) {
                rows.next();
                for (int i = 0; i < counts.length; i++) {
                    counts[i] = rows.getInt(i + 1);
                }
            }
        }
        return new Standing(counts[0], counts[1], counts[2], givenUp(connection), workers(connection));
    }

    private List<Integer> givenUp(Connection connection) throws SQLException {
        List<Integer> runs = new ArrayList<>();
        try (PreparedStatement select =
                connection.prepareStatement("SELECT run FROM runs WHERE experiment = ? AND result IS NULL AND begun >= "
                        + MOST_BEGUN + " AND ends + ? * interval '1 ms' <= clock_timestamp() ORDER BY run")) {
            select.setString(1, work);
            select.setLong(2, SILENT_LEASES * leaseMillis);
            try (ResultSet rows = select.executeQuery()) {
                while (rows.next()) {
                    runs.add(rows.getInt(1));
                }
            }
        }
        return runs;
    }

    private List<Standing.Worker> workers(Connection connection) throws SQLException {
        List<Standing.Worker> workers = new ArrayList<>();
        try (PreparedStatement select = connection.prepareStatement(
                "SELECT w.name, count(r.result), count(r.run) FILTER (WHERE r.result IS NULL AND r.ends >"
                        + " clock_timestamp()), w.ends > clock_timestamp() FROM workers w LEFT JOIN runs r ON r.worker ="
                        + " w.id WHERE w.experiment = ? GROUP BY w.id ORDER BY w.id")) {
            select.setString(1, work);
            try (ResultSet rows = select.executeQuery()) {
                while (rows.next()) {
                    workers.add(
                            new Standing.Worker(rows.getString(1), rows.getInt(2), rows.getInt(3), rows.getBoolean(4)));
                }
            }
        }
        return workers;
    }
}
