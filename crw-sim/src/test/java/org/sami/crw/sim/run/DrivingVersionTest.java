package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.sim.resume.ResumedJournal;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.SqliteJournal;
import org.sami.spn.json.ProjectWriter;

/** A journal of a run whose boats drove otherwise is refused before it is gone through, and can still be read. */
class DrivingVersionTest {
    @TempDir
    private Path folder;

    private static JournalHeader header() {
        return new RunRecord(
                        TestRuns.sampleSettings(),
                        "sample-project.json",
                        new ProjectWriter(TestRuns.LIBRARY.vocabulary())
                                .text(TestRuns.sample().project()),
                        TestRuns.LIBRARY.files().texts())
                .toHeader();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "2", "6"})
    void anEarlierRunInProcessIsRefusedInWordsAndReadAsEver(String driving) throws Exception {
        JournalHeader present = header();
        Map<String, String> settings = new TreeMap<>(present.settings());
        settings.remove("driving");
        if (!driving.isEmpty()) {
            settings.put("driving", driving);
        }
        Path file = folder.resolve("earlier.journal");
        SqliteJournal.create(
                        file,
                        JournalHeader.of(present.project(), present.vocabulary(), settings),
                        JournalOptions.DEFAULT)
                .close();

        assertThatThrownBy(() -> ResumedJournal.open(file))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("earlier.journal")
                .hasMessageContaining("drove otherwise")
                .hasMessageContaining("crw journal");
        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(RunRecord.of(reader.header()).settings()).isEqualTo(TestRuns.sampleSettings());
        }
    }

    @Test
    void aRunOfThisProgramIsTakenUp() throws Exception {
        Path file = folder.resolve("present.journal");
        SqliteJournal.create(file, header(), JournalOptions.DEFAULT).close();

        try (ResumedJournal journal = ResumedJournal.open(file)) {
            assertThat(journal.record().settings()).isEqualTo(TestRuns.sampleSettings());
        }
    }
}
