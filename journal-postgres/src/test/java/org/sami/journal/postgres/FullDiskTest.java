package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalException;
import org.sami.spn.journal.JournalReader;

/** A database on a small disk of its own, which becomes full. Needs root for the disk; says so in a line where the test has no such rights. */
@Timeout(900)
class FullDiskTest {
    private static final int BATCH = 100;

    @TempDir
    Path folder;

    private Path disk;

    @BeforeEach
    void mount() throws Exception {
        disk = Files.createDirectory(folder.resolve("disk"));
        assumeTrue(
                run("mount", "-t", "tmpfs", "-o", "size=150m", "tmpfs", disk.toString()),
                "a disk of a test's own needs root and the program mount: run as root");
    }

    @AfterEach
    void unmount() throws Exception {
        run("umount", disk.toString());
    }

    @Test
    void nothingThatWasWrittenIsLostAndTheJournalIsGoneOnWithOnceThereIsRoom() throws Exception {
        try (EmbeddedPostgres server = TestServer.builder()
                .setDataDirectory(disk.resolve("data").toFile())
                .start()) {
            String address = TestServer.address(server.getPort());
            try (PostgresJournal journal = Journals.create("laptop-1", address)) {
                journal.append(Journals.entries(0, BATCH), Durability.POWER);
                Path other = disk.resolve("other");
                fill(other);

                assertThatThrownBy(() -> {
                            while (true) {
                                journal.append(Journals.entries(journal.lastIndex(), BATCH), Durability.POWER);
                            }
                        })
                        .isInstanceOf(JournalException.class)
                        .hasMessageContaining("cannot be written: the disk of the database is full");
                long written = journal.lastIndex();
                assertThat(journal.isRecoverable()).isTrue();
                assertThatThrownBy(() -> {
                            journal.recover();
                            journal.append(Journals.entries(journal.lastIndex(), BATCH), Durability.POWER);
                        })
                        .as("there is no room yet")
                        .isInstanceOf(JournalException.class);

                Files.delete(other);
                journal.recover();
                assertThat(journal.lastIndex()).isEqualTo(written);
                journal.append(Journals.entries(written, BATCH), Durability.POWER);
                try (JournalReader reader = Journals.base("reader").read(address)) {
                    assertThat(reader.entries()).isEqualTo(Journals.entries(0, (int) written + BATCH));
                }
            }
        }
    }

    /** Takes all room that there is. */
    private static void fill(Path file) throws IOException {
        byte[] page = new byte[4096];
        try (OutputStream out = Files.newOutputStream(file)) {
            while (true) {
                out.write(page);
            }
        } catch (IOException full) {
            assertThat(full).hasMessageContaining("space");
        }
    }

    private static boolean run(String... command) throws InterruptedException {
        try {
            Process process = new ProcessBuilder(command)
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
            return process.waitFor(20, TimeUnit.SECONDS) && process.exitValue() == 0;
        } catch (IOException notInstalled) {
            return false;
        }
    }
}
