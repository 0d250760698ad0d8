package org.sami.work.postgres;

import java.io.IOException;
import java.sql.Connection;
import java.sql.SQLException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;
import org.sami.journal.postgres.Connections;
import org.sami.journal.postgres.DatabaseFaults;
import org.sami.journal.postgres.PostgresAddress;

/**
 * Work of which this process is one worker. A run that it takes stays its own while it renews the run's lease, which a thread of this object does; when the process dies, the lease ends
 * and another worker takes the run. A database that is away for half a minute is waited for. For any thread.
 */
public final class SharedRuns implements AutoCloseable {
    /** How long a run stays its worker's after the worker's last sign. */
    public static final Duration LEASE = Duration.ofSeconds(10);

    private static final int RENEWALS = 5; // a lease
    private static final int MOST_ATTEMPTS = 30;
    private static final Duration PAUSE = Duration.ofSeconds(1);
    /** Classes of faults that may pass: of the connection, of resources, of a server that restarts. */
    private static final Set<String> PASSING = Set.of("08", "53", "57");

    private final PostgresAddress address;
    private final RunTable table;
    private final Set<Integer> mine = new TreeSet<>();
    private final ScheduledExecutorService renewing = Executors.newSingleThreadScheduledExecutor(task -> {
        Thread thread = new Thread(task, "leases of runs");
        thread.setDaemon(true);
        return thread;
    });
    private @Nullable Connection connection;
    private long worker;

    private SharedRuns(PostgresAddress address, RunTable table) {
        this.address = address;
        this.table = table;
    }

    /** What is done in one transaction. */
    @FunctionalInterface
    private interface Step<T> {
        T take(Connection connection) throws SQLException, IOException;
    }

    /**
     * Enters work into the tables, or joins it where it is there.
     *
     * @param worker how this process is called to others
     * @param lease how long a run stays its worker's without a sign of it
     * @throws OtherWorkException where the work that is there has other settings
     */
    public static SharedRuns join(PostgresAddress address, SharedWork work, String worker, Duration lease)
            throws IOException {
        SharedRuns runs = new SharedRuns(address, new RunTable(work.name(), lease.toMillis()));
        try {
            runs.worker = runs.transaction(1, connection -> {
                WorkTables.make(connection, address);
                WorkTables.enter(connection, address, work);
                return runs.table.join(connection, worker);
            });
        } catch (IOException | RuntimeException fault) {
            runs.renewing.shutdownNow();
            throw fault;
        }
        long every = Math.max(1, lease.toMillis() / RENEWALS);
        Future<?> unused = runs.renewing.scheduleWithFixedDelay(runs::renew, every, every, TimeUnit.MILLISECONDS);
        return runs;
    }

    /** Takes a run that nobody has made or makes; empty where there is none now. */
    public synchronized OptionalInt take() throws IOException {
        OptionalInt taken = transaction(MOST_ATTEMPTS, connection -> table.take(connection, worker));
        taken.ifPresent(mine::add);
        return taken;
    }

    /** Keeps what came of a run. */
    public synchronized void done(int run, String result) throws IOException {
        Objects.requireNonNull(result, "result");
        transaction(MOST_ATTEMPTS, connection -> {
            table.done(connection, worker, run, result);
            return run;
        });
        mine.remove(run);
    }

    /** A run ends this worker: others may begin it once more, if it was the first time. */
    public synchronized void endsWorker(int run) throws IOException {
        mine.remove(run);
        transaction(1, connection -> {
            table.free(connection, worker, List.of(run), true);
            return run;
        });
    }

    /** How far the work is, on all machines. */
    public Standing standing() throws IOException {
        return transaction(MOST_ATTEMPTS, table::standing);
    }

    /** What came of the runs that are done, on all machines, by their numbers. */
    public Map<Integer, String> results() throws IOException {
        return transaction(MOST_ATTEMPTS, table::results);
    }

    private synchronized void renew() {
        try {
            transaction(1, connection -> {
                table.renew(connection, worker, mine);
                return worker;
            });
        } catch (IOException away) { // the next renewal, or who needs the database, finds out whether it lasts
            System.getLogger(SharedRuns.class.getName())
                    .log(System.Logger.Level.DEBUG, "renewing leases: {0}", away.getMessage());
        }
    }

    private synchronized <T> T transaction(int attempts, Step<T> step) throws IOException {
        for (int attempt = 1; ; attempt++) {
            try {
                Connection now = connection == null ? Connections.toWrite(address) : connection;
                connection = now;
                T taken = step.take(now);
                now.commit();
                return taken;
            } catch (SQLException fault) {
                drop();
                String code = String.valueOf(fault.getSQLState());
                if (attempt >= attempts || code.length() < 2 || !PASSING.contains(code.substring(0, 2))) {
                    throw new WorkException(address.words() + ": " + DatabaseFaults.words(fault), fault);
                }
                LockSupport.parkNanos(PAUSE.toNanos());
            } catch (IOException | RuntimeException fault) {
                drop();
                throw fault;
            }
        }
    }

    private void drop() {
        if (connection != null) {
            Connections.drop(connection);
            connection = null;
        }
    }

    /** Gives runs that it has not made back to others, and leaves. */
    @Override
    public synchronized void close() {
        renewing.shutdownNow();
        try {
            transaction(1, connection -> {
                table.free(connection, worker, mine, false);
                table.leave(connection, worker);
                return worker;
            });
        } catch (IOException away) { // the leases end by themselves
            System.getLogger(SharedRuns.class.getName())
                    .log(System.Logger.Level.DEBUG, "leaving: {0}", away.getMessage());
        }
        mine.clear();
        drop();
    }
}
