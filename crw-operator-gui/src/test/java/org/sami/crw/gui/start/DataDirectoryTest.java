package org.sami.crw.gui.start;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
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
    void settingsOutliveTheWindowAndADamagedFileIsAsAtFirst() throws IOException {
        Path file = folder.resolve("window.properties");
        new WindowSettings(file).keep("value.clv.@speed", "1.5");

        assertThat(new WindowSettings(file).text("value.clv.@speed")).isEqualTo("1.5");

        Files.writeString(file, "theme=\\u00zz\nscale=much");
        assertThat(new WindowSettings(file).scale()).isEqualTo(100);
    }
}
