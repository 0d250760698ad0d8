package org.sami.journal.postgres;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.sql.Connection;
import java.sql.SQLException;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * Waits until another base's lease ends, then takes it. If several bases wait, one takes it and the others go on waiting. A database that does not answer is asked again until it does. In a
 * pair the lease is judged by {@link LeaseObservation}, and a replica becomes the database before the lease is taken.
 */
final class LeaseWatch {
    private static final long LOOK_MILLIS = 100;
    private static final int ANSWER_SECONDS = 2;
    private static final int PROMOTION_SECONDS = 30;
    private static final long FOLLOWED_NANOS = 2_000_000_000L;

    private final PostgresAddress address;
    private final Taking taking;
    private final LongSupplier nanos;
    private final long forgetAfterNanos;
    private final OtherSessions others;
    private final LeaseObservation observation;
    private final Consumer<String> lines;
    private String said = "";
    private boolean answered;
    private boolean promoted;
    private Optional<Long> followsSince = Optional.empty();
    private Optional<Long> lookedNanos = Optional.empty();

    /** How a lease that is over is taken. */
    interface Taking {
        /** Takes it where it is over by the database's clock; empty if another was faster. */
        Optional<Lease> takeIfFree() throws SQLException;

        /** Takes a lease whose row was seen unchanged; empty if somebody has renewed or taken it. */
        Optional<Lease> takeSeen(LeaseTable.Holder seen) throws SQLException;
    }

    /**
     * A watch that has not begun.
     *
     * @param terms how long a lease lasts
     * @param nanos a clock that does not jump, and counts while the machine sleeps
     * @param lines what it waits for, for people; each line once in a row
     */
    LeaseWatch(PostgresAddress address, LeaseTerms terms, LongSupplier nanos, Taking taking, Consumer<String> lines) {
        this.address = address;
        this.nanos = nanos;
        this.forgetAfterNanos = terms.length().toNanos();
        this.others = new OtherSessions(address, terms.length());
        this.observation = new LeaseObservation(terms.length());
        this.taking = taking;
        this.lines = lines;
    }

    /**
     * Returns once the journal had a lease, it is over, and this process has taken it.
     *
     * @throws IOException if the database refuses the first connection
     * @throws InterruptedIOException if the thread is interrupted
     */
    Lease await() throws IOException {
        while (true) {
            try {
                Optional<Lease> taken = awaitEnd();
                if (taken.isPresent()) {
                    return taken.get();
                }
            } catch (SQLException fault) {
                if (!answered) {
                    throw DatabaseFaults.of(address, 0, "cannot be read", fault);
                }
                forget();
                say("the database does not answer: " + DatabaseFaults.words(fault));
                pause();
            }
        }
    }

    private Optional<Lease> awaitEnd() throws SQLException, InterruptedIOException {
        try (Connection connection = Connections.toRenew(address, ANSWER_SECONDS)) {
            answered = true;
            boolean ofAPair = isOfAPair(connection);
            while (true) {
                Optional<LeaseTable.Holder> holder =
                        Migrations.isThere(connection, address) ? LeaseTable.holder(connection) : Optional.empty();
                if (holder.isEmpty()) {
                    say("nobody has begun the session");
                } else if (ofAPair) {
                    if (mayTake(holder.get(), connection)) {
                        promote(connection);
                        return taking.takeSeen(holder.get());
                    }
                } else if (holder.get().left().isNegative()
                        || holder.get().left().isZero()) {
                    return taking.takeIfFree();
                } else {
                    say("the session is held by " + holder.get().words());
                }
                pause();
            }
        }
    }

    private static boolean isOfAPair(Connection connection) throws SQLException {
        return !Connections.text(connection, "SELECT current_setting('" + PairSetting.NAME + "', true)")
                .isEmpty();
    }

    private boolean mayTake(LeaseTable.Holder holder, Connection connection) throws SQLException {
        long now = nanos.getAsLong();
        if (lookedNanos.isPresent() && now - lookedNanos.get() > forgetAfterNanos) {
            forget(); // the machine slept
        }
        lookedNanos = Optional.of(now);
        boolean follows = isOfNow(connection, now);
        Optional<String> other = others.live(connection, follows, now);
        if (!isOver(holder, now, follows)) {
            return false;
        }
        if (other.isEmpty() || !isReplica(connection)) {
            return true;
        }
        say(other.get() + ": this one's replica stays a replica");
        return false;
    }

    private void forget() {
        observation.forget();
        others.forget();
        followsSince = Optional.empty();
    }

    private static boolean isReplica(Connection connection) throws SQLException {
        return Connections.text(connection, "SELECT pg_is_in_recovery()").equals("t");
    }

    private boolean isOver(LeaseTable.Holder holder, long now, boolean follows) {
        return switch (observation.look(holder, now, follows)) {
            case OVER -> true;
            case HELD -> {
                say("the session is held by " + holder.words());
                yield false;
            }
            case WATCHED -> {
                say("the session is held by " + holder.words() + "; this base goes on with it by itself");
                yield false;
            }
            case STANDS_STILL -> {
                if (promoted) {
                    yield true; // only this base writes this database, and the row stood still for its whole length
                }
                say("nothing comes from " + holder.words()
                        + ", who may go on without this base: if not, 'crw take-over'");
                yield false;
            }
        };
    }

    /** Whether the database is up to date: it is no replica, or a replica that has received and applied changes for a while. */
    private boolean isOfNow(Connection connection, long now) throws SQLException {
        boolean follows = Connections.text(
                        connection,
                        "SELECT NOT pg_is_in_recovery() OR coalesce((SELECT status = 'streaming'"
                                + " AND pg_last_wal_replay_lsn() >= latest_end_lsn FROM pg_stat_wal_receiver), false)")
                .equals("t");
        if (!follows) {
            followsSince = Optional.empty();
        } else if (followsSince.isEmpty()) {
            followsSince = Optional.of(now);
        }
        return followsSince.isPresent() && now - followsSince.get() >= FOLLOWED_NANOS;
    }

    /** Promotes the replica to be the database. */
    private void promote(Connection connection) throws SQLException {
        if (!isReplica(connection)) {
            promoted = true;
            return;
        }
        say("this base's replica becomes the database");
        Connection longer = Connections.toRenew(address, PROMOTION_SECONDS + ANSWER_SECONDS);
        try (longer) {
            if (!Connections.text(longer, "SELECT pg_promote(true, " + PROMOTION_SECONDS + ")")
                    .equals("t")) {
                throw new SQLException("the replica did not become the database within " + PROMOTION_SECONDS + " s");
            }
            promoted = true;
        }
    }

    private void say(String line) {
        if (!line.equals(said)) {
            said = line;
            lines.accept(line);
        }
    }

    private static void pause() throws InterruptedIOException {
        try {
            TimeUnit.MILLISECONDS.sleep(LOOK_MILLIS);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("interrupted while waiting for the lease of a journal");
        }
    }
}
