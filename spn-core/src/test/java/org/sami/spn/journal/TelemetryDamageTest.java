package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.StateCodec;

/**
 * Damages the pages of the telemetry table of a real journal, one after another: no entry of the engine is lost for it, and no
 * row that is not true is given back.
 */
class TelemetryDamageTest {
    private static final int PAGE = 512;
    private static final JournalOptions OPTIONS =
            JournalOptions.DEFAULT.withSnapshotEvery(4).withoutSync().withPages(PAGE, 0);
    private static final List<TelemetryRow> ROWS = IntStream.range(0, 300)
            .mapToObj(i -> new TelemetryRow(
                    i * 100L,
                    "boat" + i % 3,
                    i % 5 == 0 ? "visited" : "pose",
                    "{\"latDeg\":45." + i + ",\"lonDeg\":10}"))
            .toList();

    @TempDir
    static Path folder;

    private static Engine engine;
    private static byte[] whole;
    private static long entries;
    private static byte[] state;
    private static List<Integer> pages;

    @BeforeAll
    static void runAMission() throws Exception {
        Path file = folder.resolve("whole.journal");
        engine = Tour.engine();
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, OPTIONS)) {
            journal.addTelemetry(ROWS.subList(0, 150));
            Tour.fresh(journal).run();
            journal.addTelemetry(ROWS.subList(150, 300));
        }
        whole = Files.readAllBytes(file);
        try (JournalReader reader = JournalReader.open(file)) {
            entries = reader.lastIndex();
            state = StateCodec.encode(reader.stateAt(entries, engine));
            assertThat(reader.telemetry()).isEqualTo(new Telemetry(ROWS, Optional.empty()));
        }
        pages = pagesOfTelemetry(file);
        assertThat(pages).hasSizeGreaterThan(20);
    }

    private static List<Integer> pagesOfTelemetry(Path file) throws SQLException {
        List<Integer> found = new ArrayList<>();
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + file);
                Statement statement = connection.createStatement();
                ResultSet rows =
                        statement.executeQuery("SELECT pageno FROM dbstat WHERE name = 'telemetry' ORDER BY pageno")) {
            while (rows.next()) {
                found.add(rows.getInt(1));
            }
        }
        return found;
    }

    /** Opens a journal of these bytes twice: to read, and to go on. */
    private static int open(byte[] content) throws IOException {
        Path file = folder.resolve("damaged.journal");
        for (String name : List.of("damaged.journal", "damaged.journal-wal", "damaged.journal-shm")) {
            Files.deleteIfExists(folder.resolve(name));
        }
        Files.write(file, content);
        int read = check(file);
        try (SqliteJournal journal = SqliteJournal.open(file, OPTIONS)) {
            assertThat(journal.lastIndex()).isEqualTo(entries);
            assertThat(StateCodec.encode(journal.restore(engine))).isEqualTo(state);
            journal.addTelemetry(List.of(ROWS.get(0)));
        }
        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.telemetry().rows()).endsWith(ROWS.get(0)).hasSizeGreaterThanOrEqualTo(read);
        }
        return read;
    }

    private static int check(Path file) throws IOException {
        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.lastIndex()).isEqualTo(entries);
            Telemetry telemetry = reader.telemetry();
            assertThat(isInOrder(telemetry.rows()))
                    .as("rows as they were written")
                    .isTrue();
            if (telemetry.rows().size() < ROWS.size()) {
                assertThat(telemetry.damage()).as("what is left out is told").isPresent();
            }
            return telemetry.rows().size();
        }
    }

    private static boolean isInOrder(List<TelemetryRow> rows) {
        int next = 0;
        for (TelemetryRow row : rows) {
            int found = ROWS.subList(next, ROWS.size()).indexOf(row);
            if (found < 0) {
                return false;
            }
            next += found + 1;
        }
        return true;
    }

    @Test
    void aFlippedBitInAnyTelemetryPageCostsTelemetryAtMost() throws IOException {
        SplittableRandom random = new SplittableRandom(20_261_122);
        int flips = 0;
        int lost = 0;
        for (int page : pages) {
            for (int i = 0; i < 8; i++) {
                byte[] damaged = whole.clone();
                damaged[(page - 1) * PAGE + random.nextInt(PAGE)] ^= (byte) (1 << random.nextInt(8));
                lost += ROWS.size() - open(damaged);
                flips++;
            }
        }
        assertThat(lost).isPositive().as("most rows survive a flipped bit").isLessThan(flips * 40);
    }

    @Test
    void aTelemetryPageOfZeroesOrNoiseCostsTelemetryAtMost() throws IOException {
        SplittableRandom random = new SplittableRandom(5);
        for (int page : pages) {
            byte[] zeroes = whole.clone();
            Arrays.fill(zeroes, (page - 1) * PAGE, page * PAGE, (byte) 0);
            open(zeroes);
            byte[] noise = whole.clone();
            byte[] bytes = new byte[PAGE];
            random.nextBytes(bytes);
            System.arraycopy(bytes, 0, noise, (page - 1) * PAGE, PAGE);
            open(noise);
        }
    }

    @Test
    void rowsBehindADamagedPageAreRead() throws IOException {
        int best = 0;
        for (int page : pages) {
            byte[] zeroes = whole.clone();
            Arrays.fill(zeroes, (page - 1) * PAGE, page * PAGE, (byte) 0);
            Path file = folder.resolve("page.journal");
            Files.write(file, zeroes);
            best = Math.max(best, check(file));
            Files.delete(file);
        }
        assertThat(best).isBetween(270, 299);
    }

    @Test
    void anEmptiedTelemetryTableCostsNothingElse() throws Exception {
        Path file = folder.resolve("emptied.journal");
        Files.write(file, whole);
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + file);
                Statement statement = connection.createStatement()) {
            statement.execute("DELETE FROM telemetry");
        }
        try (SqliteJournal journal = SqliteJournal.open(file, OPTIONS)) {
            assertThat(journal.lastIndex()).isEqualTo(entries);
        }
    }

    @Test
    void journalsOfBeforeTelemetryHadChecksumsAreReadAndGoneOnWith() throws Exception {
        Path file = folder.resolve("older.journal");
        Files.write(file, whole);
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + file);
                Statement statement = connection.createStatement()) {
            statement.execute("ALTER TABLE telemetry DROP COLUMN sum");
            statement.execute("UPDATE telemetry SET at_millis = at_millis + (1 << 40) WHERE pos = 17");
        }
        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.telemetry().rows())
                    .as("all but the one that is later than those after it")
                    .hasSize(ROWS.size() - 1);
            assertThat(reader.telemetry().damage())
                    .hasValueSatisfying(words -> assertThat(words).contains("1 row is damaged"));
        }
        try (SqliteJournal journal = SqliteJournal.open(file, OPTIONS)) {
            journal.addTelemetry(List.of(ROWS.get(299)));
        }
        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.telemetry().rows()).hasSize(ROWS.size());
        }
    }
}
