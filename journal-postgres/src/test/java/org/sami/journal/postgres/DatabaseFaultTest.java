package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.io.IOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.SQLException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalException;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.StoredJournal;
import org.sami.spn.journal.TelemetryRow;

/** A database that fails loses nothing that was durable, and the journal is gone on with once it is back. */
@Timeout(900)
class DatabaseFaultTest {
    @TempDir
    Path folder;

    @Test
    void aDatabaseThatWentDownIsGoneOnWithOnceItIsBackAndNothingIsLost() throws Exception {
        try (Relay relay = new Relay()) {
            String address = TestServer.address(relay.port());
            PostgresJournal journal;
            try (EmbeddedPostgres first = server()) {
                relay.leadTo(first.getPort());
                journal = Journals.create("laptop-1", address);
                journal.append(Journals.entries(0, 300), Durability.POWER);
            }
            try (journal) {
                assertThatThrownBy(() -> journal.append(Journals.entries(300, 10), Durability.PROCESS))
                        .isInstanceOf(JournalException.class)
                        .hasMessageContaining("localhost:" + relay.port() + "/postgres")
                        .hasMessageContaining("entry 301: cannot be written: ");
                journal.addTelemetry(List.of(new TelemetryRow(1, "boat", "pose", "{}"))); // waits
                assertThatThrownBy(journal::recover).hasMessageContaining("cannot be written: ");
                assertThat(journal.isRecoverable()).isTrue();

                try (EmbeddedPostgres again = server()) {
                    relay.leadTo(again.getPort());
                    journal.recover();
                    assertThat(journal.lastIndex()).isEqualTo(300);
                    journal.append(Journals.entries(300, 10), Durability.PROCESS);
                    try (JournalReader reader = Journals.base("reader").read(address)) {
                        assertThat(reader.lastIndex()).isEqualTo(310);
                        assertThat(reader.telemetry().rows()).hasSize(1);
                    }
                    journal.close();
                }
            }
        }
    }

    private EmbeddedPostgres server() throws IOException {
        return TestServer.builder()
                .setDataDirectory(folder.resolve("data").toFile())
                .setCleanDataDirectory(false)
                .start();
    }

    @Test
    void aConnectionThatIsCutWhileABatchWaitsLosesNothing() throws Exception {
        String address = TestServer.address();
        String schema = PostgresAddress.parse(address).schema();
        try (PostgresJournal journal = Journals.create("laptop-1", address);
                Connection other = TestServer.connect(address)) {
            journal.append(Journals.entries(0, 3), Durability.PROCESS);
            other.setAutoCommit(false);
            Connections.run(other, "LOCK TABLE entries IN ACCESS EXCLUSIVE MODE");
            CompletableFuture<Void> cut = CompletableFuture.runAsync(() -> {
                try {
                    String waiting = "SELECT pg_terminate_backend(pid) FROM pg_locks WHERE NOT granted AND relation = '"
                            + schema + ".entries'::regclass";
                    while (Connections.text(other, waiting).isEmpty()) {
                        Thread.onSpinWait();
                    }
                    other.rollback();
                } catch (SQLException fault) {
                    throw new IllegalStateException(fault);
                }
            });

            assertThatThrownBy(() -> journal.append(Journals.entries(3, 1), Durability.PROCESS))
                    .isInstanceOf(JournalException.class);
            cut.join();
            assertThatThrownBy(journal::check).isInstanceOf(JournalException.class);
            journal.recover();
            assertThat(journal.lastIndex()).isEqualTo(3);
            journal.append(Journals.entries(3, 1), Durability.PROCESS);
        }
        assertThat(TestServer.number(address, "SELECT count(*) FROM entries")).isEqualTo(4);
    }

    @Test
    void tablesThatAnotherProgramLocksAreNamedAndWaitedFor() throws Exception {
        String address = TestServer.address();
        try (PostgresJournal journal = Journals.create("laptop-1", address);
                Connection other = TestServer.connect(address)) {
            other.setAutoCommit(false);
            Connections.run(other, "LOCK TABLE entries IN ACCESS EXCLUSIVE MODE");
            assertThatThrownBy(() -> journal.append(Journals.entries(0, 1), Durability.PROCESS))
                    .hasMessageContaining("another program locks its tables");
            other.rollback();

            journal.recover();
            journal.append(Journals.entries(0, 1), Durability.PROCESS);
        }
    }

    @Test
    void aBaseIsWarnedOfADatabaseThatIsGoneWhileItsLeaseLasts() throws Exception {
        try (Relay relay = new Relay()) {
            String address = TestServer.address(relay.port());
            PostgresStore often = Journals.base("laptop-1", Duration.ofMillis(50), () -> 0);
            StoredJournal journal;
            try (EmbeddedPostgres first = server()) {
                relay.leadTo(first.getPort());
                journal = often.create(address, Journals.HEADER, JournalOptions.DEFAULT);
                assertThat(journal.warning()).isEmpty();
            }
            try (journal) {
                while (journal.warning().isEmpty()) {
                    Thread.onSpinWait();
                }
                journal.check(); // its clock stands still: the lease lasts

                try (EmbeddedPostgres again = server()) {
                    relay.leadTo(again.getPort());
                    while (journal.warning().isPresent()) {
                        Thread.onSpinWait();
                    }
                }
            }
        }
    }

    @Test
    void aDatabaseWhoseDiskIsFullIsNamedAndGoneOnWithOnceThereIsRoom() throws Exception {
        String address = TestServer.address();
        try (PostgresJournal journal = Journals.create("laptop-1", address)) {
            journal.append(Journals.entries(0, 3), Durability.PROCESS);
            onEachEntry(address, "RAISE EXCEPTION 'could not extend file' USING ERRCODE = 'disk_full'");

            assertThatThrownBy(() -> journal.append(Journals.entries(3, 2), Durability.POWER))
                    .isInstanceOf(JournalException.class)
                    .hasMessageContaining("entry 4: cannot be written: the disk of the database is full");
            assertThat(journal.isRecoverable()).isTrue();
            assertThatThrownBy(journal::check).hasMessageContaining("is full");

            TestServer.run(address, "DROP TRIGGER fault ON entries");
            journal.recover();
            assertThat(journal.lastIndex()).isEqualTo(3);
            journal.append(Journals.entries(3, 2), Durability.POWER);
        }
        assertThat(TestServer.number(address, "SELECT count(*) FROM entries")).isEqualTo(5);
    }

    @Test
    void aDatabaseThatTakesTwoSecondsForABatchKeepsItsHolder() throws Exception {
        String address = TestServer.address();
        PostgresStore base = new PostgresStore(LeaseTerms.STANDARD, "laptop-1", System::nanoTime);
        try (StoredJournal journal = base.create(address, Journals.HEADER, JournalOptions.DEFAULT)) {
            onEachEntry(address, "PERFORM pg_sleep(2)");

            journal.append(Journals.entries(0, 3), Durability.POWER); // six seconds: the lease lasts three and a half

            journal.check();
            assertThat(journal.lastIndex()).isEqualTo(3);
        }
        assertThat(TestServer.number(address, "SELECT count(*) FROM holders")).isEqualTo(1);
    }

    /** Has the database do something before each entry that is written. */
    private static void onEachEntry(String address, String statement) throws SQLException {
        TestServer.run(
                address,
                "CREATE FUNCTION fault() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN " + statement
                        + "; RETURN NEW; END $$");
        TestServer.run(address, "CREATE TRIGGER fault BEFORE INSERT ON entries FOR EACH ROW EXECUTE FUNCTION fault()");
    }

    @Test
    void aDatabaseWithoutTheRightToWriteSaysSo() throws Exception {
        String address = TestServer.address();
        Journals.create("laptop-1", address).close();
        String schema = PostgresAddress.parse(address).schema();
        TestServer.run(address, "CREATE ROLE reader_" + schema + " LOGIN");
        TestServer.run(address, "GRANT USAGE ON SCHEMA " + schema + " TO reader_" + schema);
        TestServer.run(address, "GRANT SELECT ON ALL TABLES IN SCHEMA " + schema + " TO reader_" + schema);
        String asReader = address.replace("user=postgres", "user=reader_" + schema);

        try (JournalReader reader = Journals.base("reader").read(asReader)) {
            assertThat(reader.header()).isEqualTo(Journals.HEADER);
        }
        assertThatThrownBy(() -> Journals.base("laptop-2").open(asReader, JournalOptions.DEFAULT))
                .hasMessageContaining("the database's user may not do this");
        TestServer.run(address, "DROP OWNED BY reader_" + schema);
        TestServer.run(address, "DROP ROLE reader_" + schema);
    }

    @Test
    void whereNoDatabaseAnswersTheAddressIsNamed() {
        assertThatThrownBy(() -> Journals.base("laptop-1")
                        .create("postgresql://localhost:1/boats?user=pilot", Journals.HEADER, JournalOptions.DEFAULT))
                .isInstanceOf(JournalException.class)
                .hasMessage("postgresql://localhost:1/boats, head: cannot be made: no database answers there");
    }
}
