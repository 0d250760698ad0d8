package org.sami.spn.sqlite;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.SqliteJournal;
import org.sami.spn.testing.JavaProcess;

@Timeout(900)
class SqliteLibraryTest {
    @TempDir
    private Path folder;

    /** Opens a journal and dies as by {@code kill -9}. */
    static final class Killed {
        private Killed() {}

        public static void main(String[] args) throws IOException {
            SqliteJournal.create(Path.of(args[0]), JournalHeader.of("{}", Map.of(), Map.of()), JournalOptions.DEFAULT);
            Runtime.getRuntime().halt(137);
        }
    }

    @Test
    void aKilledProcessLeavesNoLibraryInTheTemporaryFolder() throws Exception {
        Path cache = folder.resolve("cache");
        for (int i = 0; i < 2; i++) {
            ProcessBuilder builder = JavaProcess.builder(
                    folder, Killed.class, folder.resolve(i + ".journal").toString());
            builder.environment().put("XDG_CACHE_HOME", cache.toString());
            Process process = builder.redirectErrorStream(true)
                    .redirectOutput(folder.resolve("said").toFile())
                    .start();
            assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
            assertThat(process.exitValue())
                    .as(Files.readString(folder.resolve("said")))
                    .isEqualTo(137);
        }

        assertThat(files(folder.resolve("tmp"))).isEmpty();
        assertThat(files(cache)).as("unpacked once for both").hasSize(1);
    }

    @Test
    void aLibraryThatWasChangedOrCutOffIsUnpackedAgain() throws IOException {
        Path file = SqliteLibrary.unpacked(folder).orElseThrow();
        byte[] whole = Files.readAllBytes(file);
        byte[] changed = whole.clone();
        changed[changed.length / 2] ^= 1;

        for (byte[] damaged : List.of(changed, new byte[0])) {
            Files.write(file, damaged);

            assertThat(SqliteLibrary.unpacked(folder)).contains(file);
            assertThat(Files.readAllBytes(file)).isEqualTo(whole);
        }
        assertThat(files(folder)).containsExactly(file);
    }

    private static List<Path> files(Path below) throws IOException {
        try (Stream<Path> all = Files.walk(below)) {
            return all.filter(Files::isRegularFile).toList();
        }
    }
}
