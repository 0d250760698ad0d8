package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.sami.spn.host.HostPlans.number;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.LongStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.Durability;
import org.sami.spn.host.HostPlans;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;
import org.sami.spn.testing.JavaProcess;

@Timeout(900)
class SqliteJournalTest {
    private static final JournalOptions OPTIONS = JournalOptions.DEFAULT;

    @TempDir
    Path folder;

    private Path file;

    @BeforeEach
    void chooseFile() {
        file = folder.resolve("session.journal");
    }

    private SqliteJournal create() throws IOException {
        return SqliteJournal.create(file, Tour.HEADER, OPTIONS);
    }

    private static List<JournalEntry> numbers(long first, long last) {
        return LongStream.rangeClosed(first, last)
                .mapToObj(i -> new JournalEntry(i, 10 * i, number(i)))
                .toList();
    }

    @Test
    void givesBackWhatWasWritten() throws Exception {
        JournalHeader header = JournalHeader.of(
                "{\"project\": \"Übung\"}",
                Map.of("domain.json", "a", "events.json", "b"),
                Map.of("seed", "42", "speed", "max"));
        try (SqliteJournal journal = SqliteJournal.create(file, header, OPTIONS)) {
            journal.append(numbers(1, 100), Durability.PROCESS);
            journal.append(numbers(101, 103), Durability.POWER);
            assertThat(journal.lastIndex()).isEqualTo(103);
            assertThat(journal.lastMillis()).isEqualTo(1030);
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.header()).isEqualTo(header);
            assertThat(reader.entries()).isEqualTo(numbers(1, 103));
            assertThat(reader.recovery().damage()).isEmpty();
            assertThat(reader.lastMillis()).isEqualTo(1030);
        }
        try (SqliteJournal again = SqliteJournal.open(file, OPTIONS)) {
            assertThat(again.header()).isEqualTo(header);
            assertThat(again.lastIndex()).isEqualTo(103);
            again.append(numbers(104, 104), Durability.PROCESS);
        }
        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.entries()).isEqualTo(numbers(1, 104));
        }
    }

    @Test
    void aClosedJournalIsOneFile() throws Exception {
        try (SqliteJournal journal = create()) {
            journal.append(numbers(1, 50), Durability.PROCESS);
            assertThat(Database.log(file)).isNotEmptyFile();
        }

        assertThat(Database.log(file)).doesNotExist();
        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.lastIndex()).isEqualTo(50);
        }
    }

    @Test
    void aReaderSeesWhatIsDurableWhileItIsWritten() throws Exception {
        try (SqliteJournal journal = create()) {
            journal.append(numbers(1, 5), Durability.PROCESS);
            try (JournalReader reader = JournalReader.open(file)) {
                journal.append(numbers(6, 9), Durability.PROCESS);
                assertThat(reader.entries()).isEqualTo(numbers(1, 5));
            }
            try (JournalReader reader = JournalReader.open(file)) {
                assertThat(reader.lastIndex()).isEqualTo(9);
            }
        }
    }

    @Test
    void anExistingFileIsNeverWrittenOver() throws Exception {
        Files.writeString(file, "precious");

        assertThatThrownBy(this::create)
                .isInstanceOf(JournalException.class)
                .hasMessageContaining(file.toString())
                .hasMessageContaining("exists already");
        assertThat(file).hasContent("precious");
    }

    @Test
    void whatAKilledProcessHadNotFinishedMakingIsNoJournalAndInNobodysWay() throws Exception {
        Path unborn = file.resolveSibling(file.getFileName() + "-new");
        Files.writeString(unborn, "begun, and killed before the header was whole");
        assertThatThrownBy(() -> SqliteJournal.open(file, OPTIONS)).hasMessageContaining("is not there");

        try (SqliteJournal journal = create()) {
            journal.append(numbers(1, 2), Durability.PROCESS);
        }

        assertThat(unborn).doesNotExist();
        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.lastIndex()).isEqualTo(2);
        }
    }

    @Test
    void whatIsNoJournalIsRefusedByName() throws Exception {
        assertThatThrownBy(() -> SqliteJournal.open(file, OPTIONS))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining("is not there");

        Files.writeString(file, "no journal at all, but long enough to be looked at");
        assertThatThrownBy(() -> SqliteJournal.open(file, OPTIONS))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining(file.toString());

        Files.write(file, new byte[0]);
        assertThatThrownBy(() -> JournalReader.open(file))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining("no journal of SAMI");
    }

    @Test
    void aSecondWriterIsToldSo() throws Exception {
        try (SqliteJournal journal = create()) {
            assertThatThrownBy(() -> SqliteJournal.open(file, OPTIONS))
                    .isInstanceOf(JournalException.class)
                    .hasMessageContaining("is being written already, by this program");
            journal.append(numbers(1, 1), Durability.PROCESS);
        }
        SqliteJournal.open(file, OPTIONS).close();
    }

    @Test
    void aSecondProcessIsToldSo() throws Exception {
        try (SqliteJournal journal = create()) {
            journal.append(numbers(1, 1), Durability.PROCESS);
            assertThat(second(file)).contains("is being written already, by another process");
            journal.append(numbers(2, 2), Durability.PROCESS);
        }
    }

    private List<Path> otherNames() throws IOException {
        Path subFolder = Files.createDirectories(folder.resolve("elsewhere"));
        Path symbolic = Files.createSymbolicLink(subFolder.resolve("symbolic.journal"), file.toAbsolutePath());
        Path hard = Files.createLink(subFolder.resolve("hard.journal"), file);
        return List.of(symbolic, hard);
    }

    @Test
    void aSecondWriterByAnotherNameIsToldSo() throws Exception {
        try (SqliteJournal journal = create()) {
            journal.append(numbers(1, 1), Durability.PROCESS);
            for (Path other : otherNames()) {
                assertThatThrownBy(() -> SqliteJournal.open(other, OPTIONS))
                        .as(other.toString())
                        .isInstanceOf(JournalException.class)
                        .hasMessageContaining("is being written already, by this program");
                assertThat(second(other)).contains("is being written already, by another process");
            }
            journal.append(numbers(2, 2), Durability.PROCESS);
        }
        for (Path other :
                List.of(folder.resolve("elsewhere/symbolic.journal"), folder.resolve("elsewhere/hard.journal"), file)) {
            try (SqliteJournal again = SqliteJournal.open(other, OPTIONS)) {
                assertThat(again.lastIndex()).isEqualTo(2);
            }
        }
    }

    @Test
    void aReaderByAHardLinkIsNotShownWhatIsOld() throws Exception {
        try (SqliteJournal journal = create()) {
            journal.append(numbers(1, 1), Durability.PROCESS);
            List<Path> others = otherNames();
            try (JournalReader reader = JournalReader.open(others.get(0))) {
                assertThat(reader.lastIndex()).isEqualTo(1);
            }
            assertThatThrownBy(() -> JournalReader.open(others.get(1)))
                    .isInstanceOf(JournalException.class)
                    .hasMessageContaining("is being written under another name");
            try (JournalReader reader = JournalReader.open(file)) {
                assertThat(reader.lastIndex()).isEqualTo(1);
            }
            assertThat(second(file)).contains("is being written already, by another process");
        }
    }

    /** What another process says that opens a file to write it. */
    private String second(Path name) throws Exception {
        Path output = folder.resolve("output");
        Process other = JavaProcess.builder(folder, SecondWriter.class, name.toString())
                .redirectErrorStream(true)
                .redirectOutput(output.toFile())
                .start();
        assertThat(other.waitFor(60, TimeUnit.SECONDS)).isTrue();
        return Files.readString(output);
    }

    /** Run as a process of its own. */
    static final class SecondWriter {
        private SecondWriter() {}

        public static void main(String[] args) throws IOException {
            try (SqliteJournal journal = SqliteJournal.open(Path.of(args[0]), OPTIONS)) {
                System.out.println("opened at " + journal.lastIndex());
            } catch (JournalException refused) {
                System.out.println(refused.getMessage());
            }
        }
    }

    @Test
    void entriesThatDoNotFollowAreAnErrorOfTheProgram() throws Exception {
        try (SqliteJournal journal = create()) {
            journal.append(numbers(1, 2), Durability.PROCESS);

            assertThatThrownBy(() -> journal.append(numbers(4, 4), Durability.PROCESS))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("entry 3");
            assertThatThrownBy(() -> journal.append(List.of(new JournalEntry(3, 19, number(3))), Durability.PROCESS))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("20 ms");
            journal.append(numbers(3, 3), Durability.PROCESS);
        }
    }

    @Test
    void aClosedJournalTakesNothing() throws Exception {
        SqliteJournal journal = create();
        journal.close();
        journal.close();

        assertThatThrownBy(() -> journal.append(numbers(1, 1), Durability.PROCESS))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining("closed");
    }

    @Test
    void batchesOfAllSizesComeBack() throws Exception {
        int last = 0;
        try (SqliteJournal journal = create()) {
            for (int size : new int[] {1, 2, 3, 4, 5, 31, 32, 33, 255, 256, 257, 293, 1000, 1}) {
                journal.append(numbers(last + 1, last + size), Durability.PROCESS);
                last += size;
            }
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.entries()).isEqualTo(numbers(1, last));
        }
    }

    @Test
    void snapshotsStandEveryNEntriesAndGiveTheStateAtAnyIndex() throws Exception {
        Engine engine = HostPlans.engine();
        var state = engine.newState();
        List<byte[]> truth = new ArrayList<>(List.of(StateCodec.encode(state)));
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, OPTIONS.withSnapshotEvery(7))) {
            for (JournalEntry entry : numbers(1, 30)) {
                engine.step(state, entry.atMillis(), entry.input());
                truth.add(StateCodec.encode(state));
                journal.append(List.of(entry), Durability.PROCESS);
                journal.offerSnapshot(() -> StateCodec.encode(state));
            }
        }

        try (JournalReader reader = JournalReader.open(file);
                Database database = Database.open(file)) {
            Contents contents = Scan.of(file.toString(), database.connection());
            assertThat(contents.snapshots().keySet()).containsExactly(7L, 14L, 21L, 28L);
            for (int i = 0; i <= 30; i++) {
                assertThat(StateCodec.encode(reader.stateAt(i, engine))).isEqualTo(truth.get(i));
            }
            assertThatThrownBy(() -> reader.stateAt(31, engine)).isInstanceOf(IllegalArgumentException.class);
        }
        try (SqliteJournal journal = SqliteJournal.open(file, OPTIONS)) {
            assertThat(StateCodec.encode(journal.restore(engine))).isEqualTo(truth.get(30));
        }
    }

    @Test
    void marksOfTheWorldAreKeptWithTheirEntries() throws Exception {
        try (SqliteJournal journal = create()) {
            journal.append(numbers(1, 2), Durability.PROCESS);
            journal.mark("two");
            journal.append(numbers(3, 3), Durability.PROCESS);
            journal.mark("tree");
            journal.mark("three");
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.marks()).containsExactly(new WorldMark(2, "two"), new WorldMark(3, "three"));
        }
    }

    @Test
    void telemetryGoesIntoTheFileByItself() throws Exception {
        TelemetryRow row = new TelemetryRow(5, "boat-1", "pose", "{\"x\":1}");
        try (SqliteJournal journal = create()) {
            journal.addTelemetry(List.of(row));
            List<TelemetryRow> seen = List.of();
            while (seen
                    .isEmpty()) { // ends: the journal writes within the time of a sync, else the test's time runs out
                try (JournalReader reader = JournalReader.open(file)) {
                    seen = reader.telemetry().rows();
                }
            }
            assertThat(seen).containsExactly(row);
        }
    }

    @Test
    void telemetryThatWaitsIsWrittenAtTheLatestWhenTheJournalIsClosed() throws Exception {
        TelemetryRow row = new TelemetryRow(5, "boat-1", "pose", "{}");
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, OPTIONS.withoutSync())) {
            journal.addTelemetry(List.of(row));
        }
        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.telemetry().rows()).containsExactly(row);
        }
    }

    @Test
    void filesThatDifferNowAreNamed() {
        JournalHeader header = JournalHeader.of("p", Map.of("a.json", "a", "b.json", "b"), Map.of());

        assertThat(header.differences("plan.json", "p", Map.of("a.json", "a", "b.json", "b")))
                .isEmpty();
        assertThat(header.differences("plan.json", "q", Map.of("a.json", "changed", "c.json", "c")))
                .containsExactlyInAnyOrder("plan.json", "a.json", "b.json", "c.json");
    }

    @Test
    void aJournalLeavesNoThread() throws Exception {
        SqliteJournal journal = create();
        journal.append(numbers(1, 1), Durability.PROCESS);
        List<Thread> own = Thread.getAllStackTraces().keySet().stream()
                .filter(thread ->
                        thread.getName().startsWith("journal-sync of " + file)) // other tests have journals too
                .toList();
        assertThat(own).hasSize(1);
        journal.close();

        own.get(0).join(60_000);
        assertThat(own.get(0).isAlive()).isFalse();
    }

    @Test
    void nonsenseOptionsAreRefused() {
        assertThatThrownBy(() -> new JournalOptions(-1, 100, true, 4096, 0))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> OPTIONS.withPages(1000, 0)).hasMessageContaining("1000");
    }
}
