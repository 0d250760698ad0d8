package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
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
            Future<?> waiting = thread.submit(() -> await(address));
            assertThat(lines.take())
                    .startsWith("the session is held by laptop-1 since")
                    .endsWith("(epoch 1)");
            first.append(Journals.entries(0, 3), Durability.PROCESS);
            assertThat(waiting.isDone()).isFalse();

            Journals.endLease(address);

            waiting.get();
            try (PostgresJournal second = Journals.base("laptop-2").open(address, JournalOptions.DEFAULT)) {
                assertThat(second.epoch()).isEqualTo(2);
                second.append(Journals.entries(3, 1), Durability.PROCESS);
            }
        }
        assertThat(TestServer.number(address, "SELECT count(*) FROM entries")).isEqualTo(4);
    }

    @Test
    void aStandbyThatIsStartedFirstWaitsForTheSessionToBegin() throws Exception {
        Future<?> waiting = thread.submit(() -> await(address));
        assertThat(lines.take()).isEqualTo("nobody has begun the session");

        PostgresJournal first = Journals.create("laptop-1", address);
        assertThat(lines.take()).startsWith("the session is held by laptop-1");
        first.close();

        waiting.get();
    }

    @Test
    void aStandbyAsksAgainWhenItsConnectionIsCut() throws Exception {
        try (EmbeddedPostgres server = TestServer.builder().start()) {
            String own = TestServer.address(server.getPort());
            try (PostgresJournal first = Journals.create("laptop-1", own)) {
                Future<?> waiting = thread.submit(() -> await(own));
                assertThat(lines.take()).startsWith("the session is held by laptop-1");

                TestServer.run(
                        own,
                        "SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE application_name ="
                                + " 'sami-journal' AND query LIKE '%FROM lease WHERE epoch > 0%'");

                assertThat(lines.take()).startsWith("the database does not answer");
                assertThat(lines.take()).startsWith("the session is held by laptop-1");
                Journals.endLease(own);
                waiting.get();
                assertThat(first.epoch()).isEqualTo(1);
            }
        }
    }

    @Test
    void aDatabaseThatWasNeverReachedEndsTheWait() {
        assertThatThrownBy(() ->
                        new PostgresStore().awaitFree("postgresql://localhost:1/postgres?user=postgres", lines::add))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("cannot be read");
    }

    @Test
    void anInterruptEndsTheWait() throws Exception {
        CompletableFuture<Throwable> end = new CompletableFuture<>();
        thread.execute(() -> {
            try {
                new PostgresStore().awaitFree(address, lines::add);
            } catch (IOException fault) {
                end.complete(fault);
            }
        });
        lines.take();

        thread.shutdownNow();

        assertThat(end.get(1, TimeUnit.MINUTES)).isInstanceOf(InterruptedIOException.class);
    }

    private Void await(String where) throws IOException {
        new PostgresStore().awaitFree(where, lines::add);
        return null;
    }
}
