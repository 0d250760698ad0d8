package org.sami.journal.postgres;

import java.io.InterruptedIOException;
import java.sql.Connection;
import java.sql.SQLException;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.sami.spn.host.JournalException;

/**
 * The right of this process to write one journal, renewed on a daemon thread of its own by a connection of its own, so that a long append delays no renewal. Safe for use by several threads.
 */
final class Lease implements AutoCloseable {
    private static final long LOOK_MILLIS = 100;
    private static final int ANSWER_SECONDS = 2;
    private static final String NO_ANSWER = "the database does not answer in time";

    /** An answer that takes longer is told. A renewal that waits for a standby takes a quarter of that now and then. */
    private static final Duration SLOW = Duration.ofSeconds(1);

    private final PostgresAddress address;
    private final LeaseTerms terms;
    private final LongSupplier nanos;
    private final long epoch;
    private final ScheduledExecutorService thread;
    private final Future<?> renewals;
    private @Nullable Connection connection; // for whoever renews
    private volatile long validUntilNanos;
    private volatile Optional<Long> openSinceNanos = Optional.empty(); // when the request was made that is not answered
    private volatile Optional<String> superseded = Optional.empty();
    private volatile Optional<String> failed = Optional.empty(); // why the last renewal did not come about

    private Lease(
            PostgresAddress address,
            LeaseTerms terms,
            LongSupplier nanos,
            long epoch,
            Connection connection,
            long askedNanos) {
        this.address = address;
        this.terms = terms;
        this.nanos = nanos;
        this.epoch = epoch;
        this.connection = connection;
        this.validUntilNanos = askedNanos + terms.ownLimit().toNanos();
        thread = Executors.newSingleThreadScheduledExecutor(work -> {
            Thread made = new Thread(work, "journal-lease of " + address.words());
            made.setDaemon(true);
            return made;
        });
        long every = terms.renewEvery().toNanos();
        renewals = thread.scheduleWithFixedDelay(this::renew, every, every, TimeUnit.NANOSECONDS);
    }

    /**
     * Takes the lease. Where another holds it this waits for its end, as a process that died leaves it behind; one that lives renews it meanwhile. It is over by the database's clock, or where
     * it stood still for its whole length: that clock may have been set back.
     *
     * @param holder how this process is called to others
     * @param nanos a clock that does not jump
     * @throws JournalException if another process holds it
     */
    static Lease take(PostgresAddress address, LeaseTerms terms, String holder, LongSupplier nanos)
            throws SQLException, JournalException, InterruptedIOException {
        Connection connection = Connections.toRenew(address, ANSWER_SECONDS);
        try {
            Optional<LeaseTable.Holder> first = Optional.empty();
            long began = nanos.getAsLong();
            while (true) {
                long asked = nanos.getAsLong();
                boolean stoodStill =
                        first.isPresent() && asked - began >= terms.length().toNanos();
                OptionalLong epoch = stoodStill
                        ? LeaseTable.takeSeen(connection, holder, terms.length(), first.get())
                        : LeaseTable.take(connection, holder, terms.length());
                if (epoch.isPresent()) {
                    return new Lease(address, terms, nanos, epoch.getAsLong(), connection, asked);
                }
                Optional<LeaseTable.Holder> other = LeaseTable.holder(connection);
                if (other.isPresent()) {
                    if (first.isPresent()
                            && !first.get().ends().equals(other.get().ends())) {
                        throw new JournalException(
                                address.words(),
                                0,
                                "is being written already, by " + other.get().words());
                    }
                    first = first.or(() -> other);
                    pause(other.get().left());
                }
            }
        } catch (SQLException | JournalException | InterruptedIOException | RuntimeException fault) {
            Connections.drop(connection);
            throw fault;
        }
    }

    /**
     * Takes the lease where nobody holds it.
     *
     * @param holder how this process is called to others
     * @param nanos a clock that does not jump
     * @return empty if another process holds it
     */
    static Optional<Lease> takeIfFree(PostgresAddress address, LeaseTerms terms, String holder, LongSupplier nanos)
            throws SQLException {
        return takeOnce(address, terms, nanos, connection -> LeaseTable.take(connection, holder, terms.length()));
    }

    private static Optional<Lease> takeOnce(
            PostgresAddress address, LeaseTerms terms, LongSupplier nanos, Taking taking) throws SQLException {
        Connection connection = Connections.toRenew(address, ANSWER_SECONDS);
        try {
            long asked = nanos.getAsLong();
            OptionalLong epoch = taking.take(connection);
            if (epoch.isEmpty()) {
                Connections.drop(connection);
                return Optional.empty();
            }
            return Optional.of(new Lease(address, terms, nanos, epoch.getAsLong(), connection, asked));
        } catch (SQLException | RuntimeException fault) {
            Connections.drop(connection);
            throw fault;
        }
    }

    /**
     * Takes the lease that was seen standing still, where nobody renewed or took it since.
     *
     * @param holder how this process is called to others
     * @param nanos a clock that does not jump
     * @return empty if somebody did
     */
    static Optional<Lease> takeSeen(
            PostgresAddress address, LeaseTerms terms, String holder, LongSupplier nanos, LeaseTable.Holder seen)
            throws SQLException {
        return takeOnce(
                address, terms, nanos, connection -> LeaseTable.takeSeen(connection, holder, terms.length(), seen));
    }

    @FunctionalInterface
    private interface Taking {
        OptionalLong take(Connection connection) throws SQLException;
    }

    private static void pause(Duration left) throws InterruptedIOException {
        try {
            TimeUnit.MILLISECONDS.sleep(Math.max(1, Math.min(LOOK_MILLIS, left.toMillis())));
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("interrupted while waiting for the lease of a journal");
        }
    }

    /** Its number among all leases of the journal. */
    long epoch() {
        return epoch;
    }

    /** Whether another has taken it: it never comes back. */
    boolean isSuperseded() {
        return superseded.isPresent();
    }

    /** Why this process may not write; empty while it may. */
    Optional<String> lost() {
        if (superseded.isPresent()) {
            return superseded;
        }
        return nanos.getAsLong() - validUntilNanos >= 0
                ? Optional.of("its lease is over, which could not be renewed: " + failed.orElse(NO_ANSWER))
                : Optional.empty();
    }

    /** Why it may soon be over: renewals fail, or one is not answered for a second. Empty while they are, and where it is over already. */
    Optional<String> warning() {
        if (lost().isPresent()) {
            return Optional.empty();
        }
        Optional<Long> asked = openSinceNanos;
        boolean late = asked.isPresent() && nanos.getAsLong() - asked.get() > SLOW.toNanos();
        return failed.or(() -> late ? Optional.of(NO_ANSWER) : Optional.empty());
    }

    private synchronized void renew() {
        if (isSuperseded() || thread.isShutdown()) {
            return;
        }
        Connection used = connection;
        openSinceNanos = Optional.of(nanos.getAsLong());
        try {
            if (used == null) {
                used = Connections.toRenew(address, ANSWER_SECONDS);
                connection = used;
            }
            renewBy(used);
        } catch (SQLException fault) {
            failed = Optional.of(DatabaseFaults.words(fault));
            if (used != null) {
                Connections.drop(used);
            }
            connection = null;
        } finally {
            openSinceNanos = Optional.empty();
        }
    }

    /**
     * Renews it, also where it was over and nobody has taken it. By a connection that commits by itself, or whose owner commits.
     *
     * @return false if another has taken it
     */
    boolean renewBy(Connection by) throws SQLException {
        long asked = nanos.getAsLong();
        if (!LeaseTable.renew(by, epoch, terms.length())) {
            superseded = Optional.of(LeaseTable.holder(by)
                    .map(other -> other.name() + " took the session over at " + other.since() + ", with epoch "
                            + other.epoch() + " after " + epoch)
                    .orElse("its lease is gone from the database"));
            return false;
        }
        validUntilNanos = asked + terms.ownLimit().toNanos();
        failed = Optional.empty();
        return true;
    }

    /** Makes sure, in the transaction of the caller, that nobody takes it before the transaction ends; else says why it is lost. */
    Optional<String> lock(Connection by) throws SQLException {
        return switch (LeaseTable.lock(by, epoch)) {
            case HELD -> Optional.empty();
            case ENDED -> Optional.of("its lease is over by the database's clock");
            case SUPERSEDED -> {
                renewBy(by); // finds out who has it
                yield superseded;
            }
        };
    }

    /** Gives it back, where the database answers. */
    @Override
    public void close() {
        renewals.cancel(false);
        thread.shutdown();
        synchronized (this) {
            Connection used = connection;
            if (used == null) {
                return;
            }
            try (Connection ended = used) {
                LeaseTable.release(ended, epoch);
            } catch (SQLException fault) {
                System.getLogger(Lease.class.getName())
                        .log(
                                System.Logger.Level.INFO,
                                "the lease of {0} was not given back and ends by itself: {1}",
                                address.words(),
                                fault.getMessage());
            }
            connection = null;
        }
    }
}
