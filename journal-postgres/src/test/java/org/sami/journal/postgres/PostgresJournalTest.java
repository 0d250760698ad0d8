package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.SqliteJournal;
import org.sami.spn.journal.StoredJournal;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.journal.WorldMark;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

/** A journal in PostgreSQL gives back what one in a file gives back. */
@Timeout(900)
class PostgresJournalTest {
    @TempDir
    Path folder;

    private final String address = TestServer.address();

    private static void fill(StoredJournal journal) throws Exception {
        journal.append(Journals.entries(0, 700), Durability.PROCESS);
        journal.addTelemetry(List.of(new TelemetryRow(5, "boat-ä1", "pose", "{\"lat\":45.5}")));
        journal.mark("all is well");
        journal.append(
                List.of(new JournalEntry(701, 800_000, new Input.LoadProject("{\"a\":\"ü\"}"))), Durability.POWER);
        journal.offerSnapshot(() -> new byte[] {1, 2, 3});
    }

    @Test
    void givesBackWhatWasWrittenWithTheHashOfAFile() throws Exception {
        JournalAddress file = JournalAddress.of(folder.resolve("a.journal"));
        JournalAddress database = JournalAddress.parse(address);
        assertThat(database.exists()).isFalse();
        for (JournalAddress each : List.of(file, database)) {
            try (StoredJournal journal = each.create(Journals.HEADER, JournalOptions.DEFAULT)) {
                assertThat(journal.inFile()).isEqualTo(each.file());
                fill(journal);
            }
        }

        assertThat(database.exists()).isTrue();
        try (JournalReader expected = file.read();
                JournalReader reader = database.read()) {
            assertThat(reader.header()).isEqualTo(Journals.HEADER);
            assertThat(reader.entries()).isEqualTo(expected.entries()).hasSize(701);
            assertThat(reader.checksum()).isEqualTo(expected.checksum());
            assertThat(reader.marks()).containsExactly(new WorldMark(700, "all is well"));
            assertThat(reader.telemetry()).isEqualTo(expected.telemetry());
            assertThat(reader.telemetry().rows()).hasSize(1);
            assertThat(reader.documents()).isEqualTo(expected.documents()).hasSize(1);
            assertThat(reader.recovery().damage()).isEmpty();
        }
    }

    @Test
    void goesOnWhereItEndedWithASnapshotWhereOneIsDue() throws Exception {
        Engine engine = new Engine(TestVocabulary.TEST, NetBuilder.project());
        var state = engine.newState();
        try (PostgresJournal journal = Journals.create("first", address)) {
            journal.append(Journals.entries(0, 1200), Durability.PROCESS);
            Journals.entries(0, 1200).forEach(entry -> engine.step(state, entry.atMillis(), entry.input()));
            journal.offerSnapshot(() -> StateCodec.encode(state));
        }

        try (PostgresJournal again = Journals.base("second").open(address, JournalOptions.DEFAULT)) {
            assertThat(again.epoch()).isEqualTo(2);
            assertThat(again.lastIndex()).isEqualTo(1200);
            assertThat(again.lastMillis()).isEqualTo(1_200_000);
            assertThat(StateCodec.encode(again.restore(engine))).isEqualTo(StateCodec.encode(state));
            again.append(Journals.entries(1200, 1), Durability.PROCESS);
        }
        assertThat(TestServer.number(address, "SELECT idx FROM snapshots")).isEqualTo(1200);
        assertThat(TestServer.number(address, "SELECT count(*) FROM entries")).isEqualTo(1201);
    }

    @Test
    void entriesThatDoNotFollowAreRefusedBeforeAnythingIsWritten() throws Exception {
        try (PostgresJournal journal = Journals.create("base", address)) {
            assertThatThrownBy(() -> journal.append(Journals.entries(1, 1), Durability.PROCESS))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("not entry 2");
            journal.append(Journals.entries(0, 1), Durability.PROCESS);
        }
    }

    @Test
    void aJournalIsNeverWrittenOverAndOneThatIsNotThereIsNamed() throws Exception {
        assertThatThrownBy(() -> Journals.base("base").read(address))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining("is not there");
        assertThatThrownBy(() -> Journals.base("base").open(address, JournalOptions.DEFAULT))
                .hasMessageContaining("is not there");
        Journals.create("base", address).close();

        assertThatThrownBy(() -> Journals.create("base", address)).hasMessageContaining("never written over");
    }

    @Test
    void anEntryThatWasChangedEndsWhatIsTrueAndWhatStoodBehindItIsKept() throws Exception {
        try (PostgresJournal journal = Journals.create("base", address)) {
            journal.append(Journals.entries(0, 20), Durability.PROCESS);
        }
        TestServer.run(address, "UPDATE entries SET input = 'garbage' WHERE idx = 11");
        try (JournalReader reader = Journals.base("reader").read(address)) {
            assertThat(reader.lastIndex()).isEqualTo(10);
        }

        try (PostgresJournal again = Journals.base("base").open(address, JournalOptions.DEFAULT)) {
            assertThat(again.recovery().damage())
                    .hasValue("entry 11 is damaged: its checksum does not hold; 10 entries are kept in the table"
                            + " set_aside");
            assertThat(again.lastIndex()).isEqualTo(10);
            again.append(Journals.entries(10, 5), Durability.PROCESS);
        }
        try (JournalReader reader = Journals.base("reader").read(address)) {
            assertThat(reader.lastIndex()).isEqualTo(15);
            assertThat(reader.recovery().damage()).isEmpty();
        }
        assertThat(TestServer.number(address, "SELECT count(*) FROM set_aside")).isEqualTo(10);
    }

    @Test
    void aHeaderThatWasChangedAndASchemaOfALaterProgramAreRefused() throws Exception {
        Journals.create("base", address).close();
        TestServer.run(address, "UPDATE header SET content = 'other' WHERE kind = 'project'");
        assertThatThrownBy(() -> Journals.base("base").open(address, JournalOptions.DEFAULT))
                .hasMessageContaining("its checksum does not hold");
        TestServer.run(address, "INSERT INTO schema_version(version) VALUES (99)");

        assertThatThrownBy(() -> Journals.base("base").open(address, JournalOptions.DEFAULT))
                .hasMessageContaining("has schema version 99");
        assertThatThrownBy(() -> Journals.base("base").read(address)).hasMessageContaining("has schema version 99");
    }

    @Test
    void telemetryThatNoTextCanHoldIsLeftOutAndNothingElseWithIt() throws Exception {
        try (PostgresJournal journal = Journals.create("base", address)) {
            journal.addTelemetry(
                    List.of(new TelemetryRow(1, "a\u0000b", "pose", "{}"), new TelemetryRow(2, "boat", "pose", "{}")));
            journal.append(Journals.entries(0, 1), Durability.PROCESS);
        }

        try (JournalReader reader = Journals.base("reader").read(address)) {
            assertThat(reader.telemetry().rows()).containsExactly(new TelemetryRow(2, "boat", "pose", "{}"));
        }
    }

    @Test
    void twoJournalsInOneDatabaseKnowNothingOfEachOther() throws Exception {
        String other = TestServer.address();
        try (PostgresJournal journal = Journals.create("base", address);
                PostgresJournal second = Journals.create("base", other)) {
            journal.append(Journals.entries(0, 3), Durability.PROCESS);
            second.append(Journals.entries(0, 5), Durability.PROCESS);
        }
        assertThat(TestServer.number(address, "SELECT count(*) FROM entries")).isEqualTo(3);
        assertThat(TestServer.number(other, "SELECT count(*) FROM entries")).isEqualTo(5);
    }

    @Test
    void aJournalInAFileNamesItsFile() throws Exception {
        Path file = folder.resolve("b.journal");
        try (StoredJournal journal = SqliteJournal.create(file, Journals.HEADER, JournalOptions.DEFAULT)) {
            assertThat(journal.inFile()).hasValue(file);
        }
    }
}
