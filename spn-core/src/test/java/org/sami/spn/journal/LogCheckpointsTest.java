package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.host.HostPlans.number;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;

/** A journal's log that is folded into the file while the journal is written. */
@Timeout(900)
class LogCheckpointsTest {
    private static final int LAST = 3000;
    private static final JournalOptions NEVER = JournalOptions.DEFAULT.withPages(4096, 0);

    @TempDir
    Path folder;

    private static List<JournalEntry> numbers(long first, long last) {
        return LongStream.rangeClosed(first, last)
                .mapToObj(i -> new JournalEntry(i, i, number(i)))
                .toList();
    }

    private long folded(Path file, int pages) throws IOException {
        try (LogCheckpoints checkpoints = new LogCheckpoints(file, pages)) {
            checkpoints.look();
        }
        return Files.size(file);
    }

    @Test
    void aLongLogIsFoldedWhileAJournalIsOpenWhichGoesOn() throws Exception {
        Path file = folder.resolve("session.journal");
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, NEVER)) {
            long begun = Files.size(file);
            journal.append(numbers(1, LAST), Durability.PROCESS);

            assertThat(folded(file, 1000)).as("the log is shorter").isEqualTo(begun);
            assertThat(folded(file, 0)).as("never").isEqualTo(begun);
            assertThat(folded(file, 20)).isEqualTo(journal.bytes());

            journal.prepare(numbers(LAST + 1, 2 * LAST));
            assertThat(folded(file, 1)).as("in the middle of a batch").isLessThanOrEqualTo(journal.bytes());
            journal.append(numbers(LAST + 1, 2 * LAST), Durability.PROCESS);
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.recovery().damage()).isEmpty();
            assertThat(reader.entries()).isEqualTo(numbers(1, 2 * LAST));
        }
    }

    @Test
    void aJournalHasItsLogFoldedByItself() throws Exception {
        Path file = folder.resolve("session.journal");
        JournalOptions options = new JournalOptions(0, 2, true, 4096, 20);
        long last = 0;
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, options)) {
            long begun = Files.size(file);
            journal.append(
                    numbers(1, LAST), Durability.PROCESS); // the log is not so long that it would be folded at once
            last = LAST;
            while (Files.size(file) == begun) {
                journal.append(numbers(last + 1, last + 1), Durability.PROCESS);
                last++;
                Thread.onSpinWait();
            }
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.entries()).isEqualTo(numbers(1, last));
        }
    }

    @Test
    void aFileThatCannotBeOpenedIsLeftAlone() throws Exception {
        Path file = folder.resolve("none.journal");
        try (LogCheckpoints checkpoints = new LogCheckpoints(file, 20)) {
            checkpoints.look();
        }

        assertThat(file).doesNotExist();
    }
}
