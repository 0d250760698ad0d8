package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.host.HostPlans.number;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.JavaProcess;

/** Kills a process that writes a journal, and asks for everything that it had said to be durable. */
@Timeout(900)
class JournalKillTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(ints = {1, 137, 1804})
    void whatWasDurableIsThereAfterAKill(int after) throws Exception {
        Path file = folder.resolve("killed.journal");
        Process writer = JavaProcess.builder(folder, Writer.class, file.toString())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        long durable = 0;
        try (BufferedReader lines = writer.inputReader(StandardCharsets.UTF_8)) {
            while (durable < after) {
                durable = Long.parseLong(lines.readLine());
            }
            writer.destroyForcibly().waitFor();
        }

        try (SqliteJournal journal = SqliteJournal.open(file, JournalOptions.DEFAULT)) {
            assertThat(journal.lastIndex()).isGreaterThanOrEqualTo(durable);
            assertThat(journal.recovery().damage()).isEmpty();
        }
        try (JournalReader reader = JournalReader.open(file)) {
            for (JournalEntry entry : reader.entries()) {
                assertThat(entry.input()).isEqualTo(input(entry.index()));
            }
        }
    }

    /** Every 20th loads a project, one of three. */
    private static Input input(long index) {
        return index % 20 == 0
                ? new Input.LoadProject("{\"id\": \"" + "p".repeat(5000) + index % 3 + "\"}")
                : number(index);
    }

    /** Writes until it is killed, and says after each batch which entry is durable. */
    static final class Writer {
        private Writer() {}

        public static void main(String[] args) throws IOException {
            JournalOptions options = JournalOptions.DEFAULT.withPages(4096, 20);
            try (SqliteJournal journal = SqliteJournal.create(Path.of(args[0]), Tour.HEADER, options)) {
                for (long i = 1; ; i++) {
                    journal.append(
                            List.of(new JournalEntry(i, i, input(i))),
                            i % 50 == 0 ? Durability.POWER : Durability.PROCESS);
                    System.out.println(i);
                }
            }
        }
    }
}
