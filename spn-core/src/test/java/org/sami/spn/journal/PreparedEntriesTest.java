package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.sami.spn.host.HostPlans.number;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.protocol.Input;

/** Entries that a journal's file gets before their batch is complete. */
@Timeout(900)
class PreparedEntriesTest {
    private static final long PLENTY = 100_000;

    @TempDir
    Path folder;

    private Path file;

    @BeforeEach
    void chooseFile() {
        file = folder.resolve("session.journal");
    }

    private SqliteJournal create() throws IOException {
        return SqliteJournal.create(file, Tour.HEADER, JournalOptions.DEFAULT);
    }

    /** Every 20th loads a project. */
    private static List<JournalEntry> entries(long first, long last) {
        return LongStream.rangeClosed(first, last)
                .mapToObj(i -> new JournalEntry(
                        i, 10 * i, i % 20 == 0 ? new Input.LoadProject("{\"id\": \"p" + i % 3 + "\"}") : number(i)))
                .toList();
    }

    private static List<String> rows(Path journal) throws Exception {
        List<String> rows = new ArrayList<>();
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + journal);
                Statement statement = connection.createStatement();
                ResultSet all = statement.executeQuery("SELECT * FROM entries ORDER BY idx")) {
            while (all.next()) {
                rows.add(all.getLong(1) + " " + all.getLong(2) + " " + all.getString(3) + " "
                        + HexFormat.of().formatHex(all.getBytes(4)));
            }
        }
        return rows;
    }

    private long lastRead() throws IOException {
        try (JournalReader reader = JournalReader.open(file)) {
            return reader.lastIndex();
        }
    }

    @Test
    void theyAreReadWithTheRestOfTheirBatchAndNotBefore() throws Exception {
        Path other = folder.resolve("other.journal");
        try (SqliteJournal journal = create();
                SqliteJournal atOnce = SqliteJournal.create(other, Tour.HEADER, JournalOptions.DEFAULT)) {
            journal.append(entries(1, 3), Durability.PROCESS);
            journal.prepare(entries(4, 200));
            journal.prepare(entries(201, 300));
            journal.bytes(); // waits for them

            assertThat(journal.lastIndex()).isEqualTo(3);
            assertThat(lastRead()).isEqualTo(3);

            journal.append(entries(4, 321), Durability.POWER);
            assertThat(lastRead()).isEqualTo(321);
            journal.prepare(entries(322, 400));
            journal.append(entries(322, 400), Durability.PROCESS);
            atOnce.append(entries(1, 400), Durability.PROCESS);
        }

        assertThat(rows(file)).hasSize(400).isEqualTo(rows(other));
    }

    @Test
    void aDiskThatIsFullInTheMiddleOfABatchTakesNoneOfIt() throws Exception {
        try (SqliteJournal journal = create()) {
            journal.append(entries(1, 3), Durability.POWER);
            journal.leaveRoomFor(4);
            for (long first = 4; first < 2000; first += 100) {
                journal.prepare(entries(first, first + 99));
            }

            assertThatThrownBy(() -> journal.append(entries(4, 2100), Durability.PROCESS))
                    .hasMessage(file + ", entry 4: cannot be written: the disk is full");
            assertThat(journal.lastIndex()).isEqualTo(3);
            assertThat(lastRead()).isEqualTo(3);

            journal.prepare(entries(4, 10)); // until it recovers it takes nothing
            journal.leaveRoomFor(PLENTY);
            journal.recover();
            journal.append(entries(4, 2100), Durability.POWER);
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.recovery().damage()).isEmpty();
            assertThat(reader.entries()).isEqualTo(entries(1, 2100));
        }
    }

    @Test
    void thoseThatAreWithdrawnLeaveNothing() throws Exception {
        try (SqliteJournal journal = create()) {
            journal.prepare(entries(1, 50));
            journal.withdraw();
            journal.withdraw();
            journal.append(List.of(new JournalEntry(1, 7, number(100))), Durability.PROCESS);
            journal.prepare(List.of(new JournalEntry(2, 7, number(101))));
            journal.mark("a world"); // nobody appends them any more
            journal.append(List.of(new JournalEntry(2, 8, number(102))), Durability.PROCESS);
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.recovery().damage()).isEmpty();
            assertThat(reader.entries())
                    .containsExactly(new JournalEntry(1, 7, number(100)), new JournalEntry(2, 8, number(102)));
        }
    }

    @Test
    void aJournalThatIsClosedInTheMiddleOfABatchHasNoneOfItButItsTelemetry() throws Exception {
        TelemetryRow row = new TelemetryRow(40, "anna", "pose", "{}");
        try (SqliteJournal journal = create()) {
            journal.prepare(entries(1, 50));
            journal.addTelemetry(List.of(row));
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.lastIndex()).isZero();
            assertThat(reader.telemetry().rows()).containsExactly(row);
        }
    }

    @Test
    void aBatchThatDoesNotFollowIsRefusedAndGoneOnFrom() throws Exception {
        try (SqliteJournal journal = create()) {
            journal.prepare(entries(1, 50));

            assertThatThrownBy(() -> journal.append(entries(2, 60), Durability.PROCESS))
                    .isInstanceOf(IllegalArgumentException.class);
            journal.withdraw();
            journal.append(entries(1, 60), Durability.PROCESS);
            assertThat(journal.lastIndex()).isEqualTo(60);
        }
    }
}
