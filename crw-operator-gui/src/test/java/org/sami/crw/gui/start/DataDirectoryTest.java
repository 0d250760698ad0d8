package org.sami.crw.gui.start;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.ui.window.WindowSettings;

class DataDirectoryTest {
    @TempDir
    private Path folder;

    @Test
    void oneWindowHasItAtATimeAndTheOtherIsToldWhichLock() throws IOException {
        DataDirectory first = DataDirectory.open(folder);

        assertThatThrownBy(() -> DataDirectory.open(folder))
                .isInstanceOf(IOException.class)
                .hasMessageContaining(folder.resolve("lock").toString())
                .hasMessageContaining("--data DIR");

        first.close();
        DataDirectory.open(folder).close();
    }

    @Test
    void directoryThatIsMadeAndItsSessionsAreReadByTheirUserOnly() throws IOException {
        assumeThat(folder.getFileSystem().supportedFileAttributeViews()).contains("posix");
        Path data = folder.resolve("sami/operator");
        DataDirectory.open(data).close();
        assertThat(permissions(data)).isEqualTo("rwx------");

        Files.setPosixFilePermissions(data.resolve("sessions"), PosixFilePermissions.fromString("rwxr-xr-x"));
        DataDirectory.open(data).close();
        assertThat(permissions(data.resolve("sessions"))).isEqualTo("rwx------");
    }

    private static String permissions(Path path) throws IOException {
        return PosixFilePermissions.toString(Files.getPosixFilePermissions(path));
    }

    @Test
    void aSessionThatWasNotFinishedIsKnownToTheNextWindow() throws IOException {
        Path journal;
        try (DataDirectory data = DataDirectory.open(folder)) {
            assertThat(data.unfinished()).isEmpty();
            journal = Files.createFile(data.newJournal());
        }
        try (DataDirectory data = DataDirectory.open(folder)) {
            assertThat(data.unfinished()).contains(journal);
            data.finished();
        }
        try (DataDirectory data = DataDirectory.open(folder)) {
            assertThat(data.unfinished()).isEmpty();
            assertThat(data.newJournal()).isNotEqualTo(journal);
        }
    }

    @Test
    void aDamagedFileOfTheUnfinishedSessionIsNamedAndSetAsideAndTheNewestJournalIsOffered() throws IOException {
        byte[][] damages = {
            {}, {'\n'}, {(byte) 0xC3, (byte) 0x28}, "../window.properties".getBytes(UTF_8), new byte[20], new byte[5000]
        };
        for (int i = 0; i < damages.length; i++) {
            Path own = folder.resolve("data" + i);
            Path journal;
            try (DataDirectory data = DataDirectory.open(own)) {
                journal = Files.createFile(data.newJournal());
            }
            Files.write(own.resolve("open-session"), damages[i]);

            try (DataDirectory data = DataDirectory.open(own)) {
                assertThat(data.unfinished()).as("damage %d", i).contains(journal);
                assertThat(data.trouble().orElseThrow())
                        .contains(own.resolve("open-session").toString())
                        .contains("set aside as open-session.damaged")
                        .contains(journal.getFileName().toString());
                assertThat(own.resolve("open-session.damaged")).hasBinaryContent(damages[i]);
                assertThat(own.resolve("open-session"))
                        .hasContent(journal.getFileName().toString());
            }
        }
    }

    @Test
    void anUnfinishedSessionWhoseJournalIsGoneIsNamed() throws IOException {
        try (DataDirectory data = DataDirectory.open(folder)) {
            Path journal = data.newJournal();

            assertThat(data.unfinished()).isEmpty();
            assertThat(data.trouble().orElseThrow())
                    .contains("not there", journal.getFileName().toString());
        }
    }

    @Test
    void settingsOutliveTheWindowAndADamagedFileIsAsAtFirst() throws IOException {
        Path file = folder.resolve("window.properties");
        new WindowSettings(file).keep("value.clv.@speed", "1.5");

        assertThat(new WindowSettings(file).text("value.clv.@speed")).isEqualTo("1.5");

        Files.writeString(file, "theme=\\u00zz\nscale=much");
        assertThat(new WindowSettings(file).scale()).isEqualTo(100);
    }
}
