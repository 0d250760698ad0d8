package org.sami.journal.postgres;

import java.io.IOException;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.sami.spn.host.JournalException;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.JournalPart;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.JournalStore;
import org.sami.spn.journal.JournalTables;
import org.sami.spn.journal.Recovery;
import org.sami.spn.journal.StoredJournal;

/** Journals in PostgreSQL. */
public final class PostgresStore implements JournalStore {
    private static final String THERE = "is there already; a journal is never written over";

    private final LeaseTerms terms;
    private final String holder;
    private final LongSupplier nanos;

    /** With the terms of a session, for this process. */
    public PostgresStore() {
        this(LeaseTerms.STANDARD, ProcessName.ofThisProcess(), ElapsedTime.ofThisMachine());
    }

    /**
     * With other terms.
     *
     * @param holder how this process is called to others
     * @param nanos a clock that does not jump
     */
    PostgresStore(LeaseTerms terms, String holder, LongSupplier nanos) {
        this.terms = terms;
        this.holder = holder;
        this.nanos = nanos;
    }

    @Override
    public String scheme() {
        return PostgresAddress.SCHEME;
    }

    @Override
    public String checked(String address) {
        return PostgresAddress.parse(address).text();
    }

    @Override
    public boolean exists(String text) throws IOException {
        PostgresAddress address = PostgresAddress.parse(text);
        try (Connection connection = Connections.toRead(address)) {
            return hasHeader(connection, address);
        } catch (SQLException fault) {
            throw DatabaseFaults.of(address, 0, "cannot be read", fault);
        }
    }

    private static boolean hasHeader(Connection connection, PostgresAddress address) throws SQLException {
        return Migrations.isThere(connection, address)
                && !Connections.text(connection, "SELECT 1 FROM header LIMIT 1").isEmpty();
    }

    @Override
    public StoredJournal create(String text, JournalHeader header, JournalOptions options) throws IOException {
        PostgresAddress address = PostgresAddress.parse(text);
        try (Connection connection = Connections.toWrite(address)) {
            Migrations.run(connection, address);
            if (hasHeader(connection, address)) {
                throw new JournalException(address.words(), 0, THERE);
            }
            JournalTables.begin(connection, header);
            connection.commit();
        } catch (SQLException fault) {
            throw DatabaseFaults.of(address, 0, "cannot be made", fault);
        }
        return open(text, options);
    }

    @Override
    public PostgresJournal open(String text, JournalOptions options) throws IOException {
        PostgresAddress address = PostgresAddress.parse(text);
        return open(address, options, () -> Lease.take(address, terms, holder, nanos), Optional::empty);
    }

    @Override
    public PostgresJournal takeOver(
            String text, JournalOptions options, Consumer<String> lines, Supplier<Optional<JournalPart>> ahead)
            throws IOException {
        PostgresAddress address = PostgresAddress.parse(text);
        Lease lease = new LeaseWatch(address, terms, nanos, taking(address), lines).await();
        try {
            lines.accept("nobody held the session any more; this base has taken it");
            return open(address, options, () -> lease, ahead);
        } catch (IOException | RuntimeException fault) {
            lease.close();
            throw fault;
        }
    }

    private LeaseWatch.Taking taking(PostgresAddress address) {
        return new LeaseWatch.Taking() {
            @Override
            public Optional<Lease> takeIfFree() throws SQLException {
                return Lease.takeIfFree(address, terms, holder, nanos);
            }

            @Override
            public Optional<Lease> takeSeen(LeaseTable.Holder seen) throws SQLException {
                return Lease.takeSeen(address, terms, holder, nanos, seen);
            }
        };
    }

    /** How a lease comes about. */
    @FunctionalInterface
    private interface Taking {
        Lease take() throws SQLException, IOException;
    }

    private static PostgresJournal open(
            PostgresAddress address, JournalOptions options, Taking lease, Supplier<Optional<JournalPart>> ahead)
            throws IOException {
        try {
            Connection connection = Connections.toWrite(address);
            try {
                if (!Migrations.isThere(connection, address)) {
                    throw new JournalException(address.words(), 0, "is not there");
                }
                Migrations.run(connection, address);
                connection.commit();
                return opened(address, connection, lease.take(), ahead, options);
            } catch (SQLException | IOException | RuntimeException fault) {
                Connections.drop(connection);
                throw fault;
            }
        } catch (SQLException fault) {
            throw DatabaseFaults.of(address, 0, "cannot be opened", fault);
        }
    }

    private static PostgresJournal opened(
            PostgresAddress address,
            Connection connection,
            Lease lease,
            Supplier<Optional<JournalPart>> ahead,
            JournalOptions options)
            throws SQLException, IOException {
        try {
            JournalTables tables =
                    JournalTables.open(address.words(), connection, new PostgresRows(connection), ahead.get(), options);
            Recovery found = tables.recovery();
            Optional<String> damage = Optional.empty();
            if (found.damage().isPresent()) {
                long rows = setAside(connection, found.lastValid());
                damage = found.damage()
                        .map(what -> what + "; " + rows + (rows == 1 ? " entry is" : " entries are")
                                + " kept in the table set_aside");
            }
            connection.commit();
            return new PostgresJournal(
                    address, connection, lease, tables, new Recovery(found.lastValid(), damage), options);
        } catch (SQLException | IOException | RuntimeException fault) {
            lease.close();
            throw fault;
        }
    }

    /** Makes room behind the last valid entry; what stood there is kept as it was found. */
    private static long setAside(Connection connection, long lastValid) throws SQLException {
        try (PreparedStatement move = connection.prepareStatement(
                "WITH gone AS (DELETE FROM entries WHERE idx > ? RETURNING idx, at_millis, input, checksum)"
                        + " INSERT INTO set_aside SELECT clock_timestamp(), * FROM gone")) {
            move.setLong(1, lastValid);
            return move.executeUpdate();
        }
    }

    @Override
    public Optional<JournalHeader> header(String text) throws IOException {
        PostgresAddress address = PostgresAddress.parse(text);
        try (Connection connection = Connections.toRead(address)) {
            return hasHeader(connection, address)
                    ? Optional.of(JournalTables.header(address.words(), connection))
                    : Optional.empty();
        } catch (SQLException fault) {
            throw DatabaseFaults.of(address, 0, "cannot be read", fault);
        }
    }

    @Override
    public JournalReader read(String text, Optional<JournalPart> known) throws JournalException {
        PostgresAddress address = PostgresAddress.parse(text);
        return known.isPresent() ? PostgresReading.follow(address, known.get()) : PostgresReading.open(address, known);
    }
}
