package org.sami.journal.postgres;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.sql.Connection;
import java.sql.SQLException;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/** Waits for the end of another's lease and takes it then; of several that wait, the others go on waiting. A database that is gone meanwhile is asked again until it answers. */
final class LeaseWatch {
    private static final long LOOK_MILLIS = 100;
    private static final int ANSWER_SECONDS = 2;

    private final PostgresAddress address;
    private final Taking taking;
    private final Consumer<String> lines;
    private String said = "";
    private boolean answered;

    /** How a lease that is over is taken. */
    @FunctionalInterface
    interface Taking {
        /** Takes it; empty if another was faster. */
        Optional<Lease> take() throws SQLException;
    }

    /**
     * A watch that has not begun.
     *
     * @param lines what it waits for, for people; each line once in a row
     */
    LeaseWatch(PostgresAddress address, Taking taking, Consumer<String> lines) {
        this.address = address;
        this.taking = taking;
        this.lines = lines;
    }

    /**
     * Returns once the journal had a lease, it is over by the database's clock, and this process has taken it.
     *
     * @throws IOException if the database refuses the first connection
     * @throws InterruptedIOException if the thread is interrupted
     */
    Lease await() throws IOException {
        while (true) {
            try {
                awaitEnd();
                Optional<Lease> taken = taking.take();
                if (taken.isPresent()) {
                    return taken.get();
                }
            } catch (SQLException fault) {
                if (!answered) {
                    throw DatabaseFaults.of(address, 0, "cannot be read", fault);
                }
                say("the database does not answer: " + DatabaseFaults.words(fault));
                pause();
            }
        }
    }

    private void awaitEnd() throws SQLException, InterruptedIOException {
        try (Connection connection = Connections.toRenew(address, ANSWER_SECONDS)) {
            answered = true;
            while (!isOver(connection)) {
                pause();
            }
        }
    }

    private boolean isOver(Connection connection) throws SQLException {
        Optional<LeaseTable.Holder> holder =
                Migrations.isThere(connection, address) ? LeaseTable.holder(connection) : Optional.empty();
        if (holder.isEmpty()) {
            say("nobody has begun the session");
            return false;
        }
        if (holder.get().left().isNegative() || holder.get().left().isZero()) {
            return true;
        }
        say("the session is held by " + holder.get().words());
        return false;
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
