package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.sql.SQLException;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.spn.host.Durability;
import org.sami.spn.journal.JournalOptions;

/** A standby waits for the end of another base's lease, and then goes on with its journal. */
@Timeout(300)
class LeaseWatchTest {
    private final String address = TestServer.address();
    private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();
    private final ExecutorService thread = Executors.newSingleThreadExecutor();

    @AfterEach
    void end() {
        thread.shutdownNow();
    }

    @Test
    void aStandbyWaitsWhileTheOtherHoldsItAndGoesOnWithAllEntries() throws Exception {
        try (PostgresJournal first = Journals.create("laptop-1", address)) {
            Future<PostgresJournal> waiting = thread.submit(() -> takeOver("laptop-2", address, lines::add));
            assertThat(lines.take())
                    .startsWith("the session is held by laptop-1 since")
                    .endsWith("(epoch 1)");
            first.append(Journals.entries(0, 3), Durability.PROCESS);
            assertThat(waiting.isDone()).isFalse();

            Journals.endLease(address);

            try (PostgresJournal second = waiting.get()) {
                assertThat(second.epoch()).isEqualTo(2);
                second.append(Journals.entries(3, 1), Durability.PROCESS);
            }
        }
        assertThat(TestServer.number(address, "SELECT count(*) FROM entries")).isEqualTo(4);
    }

    @Test
    void aStandbyThatIsStartedFirstWaitsForTheSessionToBegin() throws Exception {
        Future<PostgresJournal> waiting = thread.submit(() -> takeOver("laptop-2", address, lines::add));
        assertThat(lines.take()).isEqualTo("nobody has begun the session");

        PostgresJournal first = Journals.create("laptop-1", address);
        assertThat(lines.take()).startsWith("the session is held by laptop-1");
        first.close();

        waiting.get().close();
    }

    @Test
    void aStandbyAsksAgainWhenItsConnectionIsCut() throws Exception {
        try (EmbeddedPostgres server = TestServer.builder().start()) {
            String own = TestServer.address(server.getPort());
            try (PostgresJournal first = Journals.create("laptop-1", own)) {
                Future<PostgresJournal> waiting = thread.submit(() -> takeOver("laptop-2", own, lines::add));
                assertThat(lines.take()).startsWith("the session is held by laptop-1");

                TestServer.run(
                        own,
                        "SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE application_name ="
                                + " 'sami-journal' AND query LIKE '%FROM lease WHERE epoch > 0%'");

                assertThat(lines.take()).startsWith("the database does not answer");
                assertThat(lines.take()).startsWith("the session is held by laptop-1");
                Journals.endLease(own);
                try (PostgresJournal second = waiting.get()) {
                    assertThat(second.epoch()).isEqualTo(first.epoch() + 1);
                }
            }
        }
    }

    @Test
    void ofTwoStandbysOneTakesTheSessionAndTheOtherGoesOnWaitingForIt() throws Exception {
        BlockingQueue<PostgresJournal> taken = new LinkedBlockingQueue<>();
        BlockingQueue<String> ofThird = new LinkedBlockingQueue<>();
        ExecutorService both = Executors.newFixedThreadPool(2);
        try (PostgresJournal first = Journals.create("laptop-1", address)) {
            both.execute(() -> taken.add(journal("laptop-2", lines)));
            both.execute(() -> taken.add(journal("laptop-3", ofThird)));
            assertThat(lines.take()).startsWith("the session is held by laptop-1");
            assertThat(ofThird.take()).startsWith("the session is held by laptop-1");

            Journals.endLease(address);
            PostgresJournal faster = taken.take();
            String ofSecond = lines.take();
            boolean second = ofSecond.startsWith("nobody held");
            String late = second ? ofThird.take() : ofSecond;

            assertThat(late)
                    .startsWith("the session is held by laptop-" + (second ? 2 : 3))
                    .endsWith("(epoch 2)");
            assertThat(taken).isEmpty();
            faster.append(Journals.entries(0, 3), Durability.PROCESS);
            faster.close();
            try (PostgresJournal later = taken.take()) {
                assertThat(later.epoch()).isEqualTo(first.epoch() + 2);
                assertThat(later.lastIndex()).isEqualTo(3);
            }
        } finally {
            both.shutdownNow();
        }
    }

    @Test
    void aStandbyThatFoundTheLeaseOverAndCameTooLateGoesOnWaiting() throws Exception {
        try (PostgresJournal first = Journals.create("laptop-1", address)) {
            Journals.endLease(address);
            CompletableFuture<PostgresJournal> faster = new CompletableFuture<>();
            PostgresAddress parsed = PostgresAddress.parse(address);
            LeaseTerms terms =
                    new LeaseTerms(Journals.OWN_LIMIT.multipliedBy(2), Journals.OWN_LIMIT, Journals.OWN_LIMIT);
            LeaseWatch late = new LeaseWatch(
                    parsed,
                    terms,
                    System::nanoTime,
                    new LeaseWatch.Taking() {
                        @Override
                        public Optional<Lease> takeIfFree() throws SQLException {
                            if (!faster.isDone()) {
                                faster.complete(open("laptop-2")); // between the look and the take
                            }
                            return Lease.takeIfFree(parsed, terms, "laptop-3", System::nanoTime);
                        }

                        @Override
                        public Optional<Lease> takeSeen(LeaseTable.Holder seen) {
                            throw new AssertionError("this database is none of a pair");
                        }
                    },
                    lines::add);
            Future<Lease> waiting = thread.submit(late::await);

            assertThat(lines.take())
                    .startsWith("the session is held by laptop-2")
                    .endsWith("(epoch 2)");
            assertThat(waiting.isDone()).isFalse();
            faster.get().close();
            try (Lease taken = waiting.get()) {
                assertThat(taken.epoch()).isEqualTo(first.epoch() + 2);
            }
        }
    }

    /** As after the lid of a laptop was opened: what its replica says of the other base is old then. */
    @Test
    void aStandbyWhoseMachineSleptBetweenItsLooksDoesNotTakeWhatIsGivenBack() throws Exception {
        TestServer.run(address, "CREATE ROLE of_a_pair SUPERUSER LOGIN");
        TestServer.run(address, "ALTER ROLE of_a_pair SET " + PairSetting.NAME + " = '" + PairSetting.ALONE + "'");
        Journals.create("laptop-1", address).close();
        PostgresAddress parsed = PostgresAddress.parse(address.replace("user=postgres", "user=of_a_pair"));
        int sleeps = 4;
        AtomicInteger looks = new AtomicInteger();
        AtomicLong nanos = new AtomicLong();
        AtomicInteger looksUntilTaken = new AtomicInteger();
        LeaseWatch watch = new LeaseWatch(
                parsed,
                LeaseTerms.STANDARD,
                () -> nanos.addAndGet(looks.incrementAndGet() <= sleeps ? 30_000_000_000L : 400_000_000),
                new LeaseWatch.Taking() {
                    @Override
                    public Optional<Lease> takeIfFree() {
                        throw new AssertionError("this database is of a pair");
                    }

                    @Override
                    public Optional<Lease> takeSeen(LeaseTable.Holder seen) throws SQLException {
                        looksUntilTaken.set(looks.get());
                        return Lease.takeSeen(parsed, LeaseTerms.STANDARD, "laptop-2", System::nanoTime, seen);
                    }
                },
                lines::add);

        watch.await().close();

        assertThat(looksUntilTaken.get()).as("it followed for 2 s while awake").isEqualTo(sleeps + 5);
    }

    private PostgresJournal journal(String name, BlockingQueue<String> said) {
        try {
            return takeOver(name, address, said::add);
        } catch (IOException fault) {
            throw new UncheckedIOException(fault);
        }
    }

    private PostgresJournal open(String name) {
        try {
            return Journals.base(name).open(address, JournalOptions.DEFAULT);
        } catch (IOException fault) {
            throw new UncheckedIOException(fault);
        }
    }

    @Test
    void aDatabaseThatWasNeverReachedEndsTheWait() {
        assertThatThrownBy(() -> takeOver("laptop-2", "postgresql://localhost:1/postgres?user=postgres", lines::add))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("cannot be read");
    }

    @Test
    void anInterruptEndsTheWait() throws Exception {
        CompletableFuture<Throwable> end = new CompletableFuture<>();
        thread.execute(() -> {
            try {
                takeOver("laptop-2", address, lines::add).close();
            } catch (IOException fault) {
                end.complete(fault);
            }
        });
        lines.take();

        thread.shutdownNow();

        assertThat(end.get(1, TimeUnit.MINUTES)).isInstanceOf(InterruptedIOException.class);
    }

    private PostgresJournal takeOver(String name, String where, Consumer<String> said) throws IOException {
        return Journals.base(name).takeOver(where, JournalOptions.DEFAULT, said, Optional::empty);
    }
}
