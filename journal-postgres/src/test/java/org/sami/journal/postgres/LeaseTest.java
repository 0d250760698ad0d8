package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.postgresql.PGConnection;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalException;
import org.sami.spn.journal.Checksum;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.RowWriter.EntryRow;
import org.sami.spn.journal.StoredJournal;

/** One base writes a journal at a time, and the database refuses whoever was superseded. */
@Tag("long")
@Timeout(900)
class LeaseTest {
    private static final int TAKE_OVERS = 10_000;
    private static final int RENEWALS = 4;

    private final String address = TestServer.address();

    @Test
    void aSecondBaseIsRefusedByNameWhileTheFirstRenewsItsLease() throws Exception {
        PostgresStore often = Journals.base("laptop-1 (process 7)", Duration.ofMillis(100), System::nanoTime);
        try (StoredJournal first = often.create(address, Journals.HEADER, JournalOptions.DEFAULT)) {
            assertThatThrownBy(() -> Journals.base("laptop-2").open(address, JournalOptions.DEFAULT))
                    .isInstanceOf(JournalException.class)
                    .hasMessageContaining("is being written already, by laptop-1 (process 7)")
                    .hasMessageContaining("(epoch 1)");

            first.append(Journals.entries(0, 1), Durability.PROCESS);
        }
    }

    @Test
    void aBaseThatClosedIsFollowedAtOnce() throws Exception {
        Journals.create("laptop-1", address).close();

        assertThat(TestServer.number(address, "SELECT count(*) FROM lease WHERE ends <= clock_timestamp()"))
                .isEqualTo(1);
        try (PostgresJournal second = Journals.base("laptop-2").open(address, JournalOptions.DEFAULT)) {
            assertThat(second.epoch()).isEqualTo(2);
        }
        assertThat(TestServer.number(address, "SELECT count(*) FROM holders")).isEqualTo(2);
    }

    @Test
    void whatASupersededBaseWritesIsRefusedAndItSaysByWhom() throws Exception {
        try (PostgresJournal first = Journals.create("laptop-1", address)) {
            first.append(Journals.entries(0, 2), Durability.PROCESS);
            Journals.endLease(address);
            try (PostgresJournal second = Journals.base("laptop-2").open(address, JournalOptions.DEFAULT)) {
                assertThatThrownBy(() -> first.append(Journals.entries(2, 1), Durability.POWER))
                        .isInstanceOf(JournalException.class)
                        .hasMessageContaining("entry 3: cannot be written: laptop-2 took the session over at")
                        .hasMessageContaining("with epoch 2 after 1");
                assertThat(first.isRecoverable()).isFalse();
                assertThatThrownBy(first::recover).hasMessageContaining("took the session over");
                assertThatThrownBy(first::check).hasMessageContaining("took the session over");
                assertThatThrownBy(() -> first.mark("here")).hasMessageContaining("took the session over");

                second.append(Journals.entries(2, 1), Durability.POWER);
            }
        }
        assertThat(TestServer.number(address, "SELECT count(*) FROM entries")).isEqualTo(3);
    }

    @Test
    void aBaseWhoseClockSaysThatItsLeaseIsOverWritesNothingUntilItHasRenewedIt() throws Exception {
        AtomicLong nanos = new AtomicLong();
        PostgresStore store = Journals.base("laptop-1", Journals.OWN_LIMIT, nanos::get);
        try (PostgresJournal journal =
                (PostgresJournal) store.create(address, Journals.HEADER, JournalOptions.DEFAULT)) {
            journal.append(Journals.entries(0, 1), Durability.PROCESS);
            nanos.addAndGet(Journals.OWN_LIMIT.toNanos());

            assertThatThrownBy(journal::check).hasMessageContaining("its lease is over, which could not be renewed");
            assertThatThrownBy(() -> journal.append(Journals.entries(1, 1), Durability.PROCESS))
                    .hasMessageContaining("its lease is over");
            assertThat(journal.isRecoverable()).isTrue();
            journal.recover();
            journal.append(Journals.entries(1, 1), Durability.PROCESS);
        }
    }

    @Test
    void aBaseIsWarnedOfARenewalThatIsNotAnsweredForASecondBeforeItsLeaseIsOver() throws Exception {
        AtomicLong nanos = new AtomicLong();
        AtomicInteger readings = new AtomicInteger();
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch answered = new CountDownLatch(1);
        PostgresStore store = Journals.base("laptop-1", Duration.ofMillis(50), () -> {
            if (Thread.currentThread().getName().startsWith("journal-lease") && readings.incrementAndGet() == 2) {
                begun.countDown(); // its first reading began the renewal, which stands still here
                awaitQuietly(answered);
            }
            return nanos.get();
        });
        try (StoredJournal journal = store.create(address, Journals.HEADER, JournalOptions.DEFAULT)) {
            begun.await();
            nanos.addAndGet(Duration.ofMillis(900).toNanos());
            assertThat(journal.warning()).isEmpty();
            nanos.addAndGet(Duration.ofMillis(200).toNanos());
            assertThat(journal.warning()).contains("the database does not answer in time");
            journal.check(); // it may still write

            answered.countDown();
            while (journal.warning().isPresent()) {
                Thread.onSpinWait();
            }
        }
    }

    @Test
    void aBaseIsNotWarnedWhileNoRenewalIsUnderWayHoweverLongTheLastOneTook() throws Exception {
        AtomicLong nanos = new AtomicLong();
        PostgresStore store = Journals.base("laptop-1", Journals.OWN_LIMIT, nanos::get);
        try (StoredJournal journal = store.create(address, Journals.HEADER, JournalOptions.DEFAULT)) {
            nanos.addAndGet(Duration.ofMillis(1600).toNanos());
            assertThat(journal.warning()).isEmpty();

            nanos.addAndGet(Journals.OWN_LIMIT.toNanos());
            assertThatThrownBy(journal::check).hasMessageContaining("its lease is over");
            assertThat(journal.warning())
                    .as("that of a journal that has failed")
                    .isEmpty();
            journal.recover();
            assertThat(journal.warning()).isEmpty();
        }
    }

    private static void awaitQuietly(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
    }

    @Test
    void aWritingThatIsNotAnsweredByTheEndOfTheLeaseFailsThenAndIsGoneOnWith() throws Exception {
        AtomicLong nanos = new AtomicLong();
        PostgresStore store = Journals.base("laptop-1", Journals.OWN_LIMIT, nanos::get);
        try (StoredJournal journal = store.create(address, Journals.HEADER, JournalOptions.DEFAULT);
                Connection holding = TestServer.connect(address)) {
            holding.setAutoCommit(false);
            Connections.run(holding, "LOCK TABLE entries IN ACCESS EXCLUSIVE MODE");
            CompletableFuture<Void> over = CompletableFuture.runAsync(() -> {
                awaitWaiting(holding);
                nanos.addAndGet(Journals.OWN_LIMIT.toNanos());
            });

            assertThatThrownBy(() -> journal.append(Journals.entries(0, 1), Durability.PROCESS))
                    .isInstanceOf(JournalException.class)
                    .hasMessageContaining("entry 1: cannot be written: its lease is over, which could not be renewed");

            over.join();
            holding.rollback();
            journal.recover();
            journal.append(Journals.entries(journal.lastIndex(), 1), Durability.PROCESS);
        }
    }

    private static void awaitWaiting(Connection by) {
        try {
            while (Connections.text(by, "SELECT 1 FROM pg_locks WHERE NOT granted AND relation = 'entries'::regclass")
                    .isEmpty()) {
                Thread.onSpinWait();
            }
        } catch (SQLException fault) {
            throw new IllegalStateException(fault);
        }
    }

    @Test
    void theDatabasesClockDecidesWhateverTheBaseBelieves() throws Exception {
        long aDayOff = -Duration.ofDays(1).toNanos();
        PostgresStore store = Journals.base("laptop-1", Journals.OWN_LIMIT, () -> aDayOff);
        try (PostgresJournal journal =
                (PostgresJournal) store.create(address, Journals.HEADER, JournalOptions.DEFAULT)) {
            journal.append(Journals.entries(0, 1), Durability.PROCESS);
            Journals.endLease(address);

            assertThatThrownBy(() -> journal.append(Journals.entries(1, 1), Durability.PROCESS))
                    .hasMessageContaining("its lease is over by the database's clock");
            journal.recover(); // nobody has taken it
            journal.append(Journals.entries(1, 1), Durability.PROCESS);
        }
    }

    @Test
    void aLeaseThatIsGoneFromTheTableIsLost() throws Exception {
        try (PostgresJournal journal = Journals.create("laptop-1", address)) {
            TestServer.run(address, "DELETE FROM lease");

            assertThatThrownBy(() -> journal.append(Journals.entries(0, 1), Durability.PROCESS))
                    .hasMessageContaining("its lease is gone from the database");
        }
    }

    /** Something holds the row, as a renewal does that waits for a standby which is gone. */
    @Test
    void renewalsThatNobodyWaitsForAnyMoreDoNotPileUpInTheDatabase() throws Exception {
        PostgresStore often = Journals.base("laptop-1", Duration.ofMillis(100), System::nanoTime);
        Set<Long> seen = new HashSet<>();
        try (Connection holding = TestServer.connect(address)) {
            try (StoredJournal journal = often.create(address, Journals.HEADER, JournalOptions.DEFAULT);
                    Statement hold = holding.createStatement();
                    Connection looking = TestServer.connect(address);
                    PreparedStatement waiting = looking.prepareStatement(
                            "SELECT DISTINCT pid FROM pg_locks WHERE relation = 'lease'::regclass AND pid <> ?")) {
                holding.setAutoCommit(false);
                hold.execute("UPDATE lease SET ends = ends");
                waiting.setInt(1, ((PGConnection) holding).getBackendPID());
                while (seen.size() < RENEWALS) {
                    Set<Long> now = new HashSet<>();
                    try (ResultSet rows = waiting.executeQuery()) {
                        while (rows.next()) {
                            now.add(rows.getLong(1));
                        }
                    }
                    seen.addAll(now);
                    assertThat(now).as("at the same time, of %s", seen).hasSizeLessThan(RENEWALS - 1);
                }
                holding.rollback();
            }
        }
    }

    /** Two bases take the lease from each other while both append as fast as they can. The row is so wide that it goes to another page often, where PostgreSQL loses a lock of its key. */
    @Test
    @Timeout(1200)
    void noEntryOfASupersededBaseIsWrittenInTenThousandTakeOvers() throws Exception {
        Journals.create("nobody", address).close();
        TestServer.run(address, "ALTER TABLE lease ADD COLUMN wide text NOT NULL DEFAULT repeat('x', 1900)");
        TestServer.run(address, "ALTER TABLE lease ALTER COLUMN wide SET STORAGE PLAIN");
        ExecutorService threads = Executors.newFixedThreadPool(3);
        AtomicLong newest = new AtomicLong();
        try {
            List<Future<Long>> bases =
                    List.of(threads.submit(() -> rival(newest)), threads.submit(() -> rival(newest)));
            Future<Long> renewals = threads.submit(() -> renewals(newest));
            long taken = 0;
            for (Future<Long> base : bases) {
                taken += base.get();
            }
            assertThat(taken).isGreaterThanOrEqualTo(TAKE_OVERS);
            assertThat(renewals.get()).isPositive();
        } finally {
            newest.set(Long.MAX_VALUE); // also where one of them failed
            threads.shutdown();
        }

        assertThat(TestServer.number(address, "SELECT count(*) FROM holders")).isGreaterThan(TAKE_OVERS);
        assertThat(TestServer.number(address, "SELECT count(*) FROM entries")).isGreaterThan(TAKE_OVERS / 100);
        // Epochs stand in the column of times: in order of entries none comes after a later one.
        assertThat(TestServer.number(
                        address,
                        "SELECT count(*) FROM (SELECT at_millis, max(at_millis) OVER (ORDER BY idx ROWS BETWEEN"
                                + " UNBOUNDED PRECEDING AND 1 PRECEDING) AS before FROM entries) AS e WHERE at_millis <"
                                + " before"))
                .isZero();
    }

    /** Writes the row again and again, as a holder does that renews its lease; gives how often. */
    private long renewals(AtomicLong newest) throws SQLException {
        long renewed = 0;
        try (Connection connection = TestServer.connect(address)) {
            while (newest.get() <= TAKE_OVERS) {
                Connections.run(connection, "UPDATE lease SET ends = ends");
                renewed++;
            }
        }
        return renewed;
    }

    /** Takes the lease whenever it can and appends until it is refused; gives how often it took it. */
    private long rival(AtomicLong newest) throws SQLException {
        long taken = 0;
        try (Connection connection = TestServer.connect(address)) {
            connection.setAutoCommit(false);
            PostgresRows rows = new PostgresRows(connection);
            while (newest.get() <= TAKE_OVERS) {
                Connections.run(connection, "UPDATE lease SET ends = clock_timestamp()");
                connection.commit();
                OptionalLong epoch = LeaseTable.take(connection, "rival", Duration.ofHours(1));
                connection.commit();
                if (epoch.isPresent()) {
                    taken++;
                    newest.accumulateAndGet(epoch.getAsLong(), Math::max);
                    boolean newestHolder = true;
                    while (newestHolder && append(connection, rows, epoch.getAsLong())) {
                        newestHolder = newest.get() == epoch.getAsLong() && newest.get() <= TAKE_OVERS;
                    }
                    append(connection, rows, epoch.getAsLong()); // superseded, perhaps
                }
            }
        }
        return taken;
    }

    private static boolean append(Connection connection, PostgresRows rows, long epoch) throws SQLException {
        boolean held = LeaseTable.lock(connection, epoch) == LeaseTable.Standing.HELD;
        if (held) {
            long last = Long.parseLong(Connections.text(connection, "SELECT coalesce(max(idx), 0) FROM entries"));
            try {
                rows.entries(List.of(new EntryRow(last + 1, epoch, "{}", new Checksum(0, 0))));
            } catch (SQLException refused) {
                connection.rollback();
                throw new SQLException(
                        "holder of epoch " + epoch + ", entry " + (last + 1) + ", now: "
                                + Connections.text(
                                        connection,
                                        "SELECT 'lease ' || l.epoch || ', entry of ' || e.at_millis || ', last '"
                                                + " || (SELECT max(idx) FROM entries) FROM lease l LEFT JOIN entries e"
                                                + " ON e.idx = " + (last + 1)),
                        refused);
            }
        }
        connection.commit();
        return held;
    }
}
