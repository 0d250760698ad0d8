package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.engine.RuleVersion;
import org.sami.spn.host.JournalException;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.SqliteJournal;

/** Journals replay to the firings that were, or are refused in words: the version of the rules stands in their headers. */
class RuleVersionTest {
    @TempDir
    private Path folder;

    @Test
    void sessionsThatWereRecordedByTheseRulesReplayToTheirHashes() throws Exception {
        assertThat(RecordedSessions.of(RuleVersion.CURRENT))
                .hasSizeGreaterThan(5)
                .allSatisfy(session -> assertThat(RecordedSessions.hash(session.project(), session.inputs()))
                        .as("A rule of firing has changed: raise RuleVersion.CURRENT, and record sessions by"
                                + " RecordedSessions.main")
                        .isEqualTo(session.hash()));
    }

    private Path journal(Map<String, String> settings) throws Exception {
        Path file = folder.resolve("old.journal");
        SqliteJournal.create(
                        file,
                        new JournalHeader(JournalHeader.CURRENT_VERSION, "{}", Map.of(), settings),
                        JournalOptions.DEFAULT)
                .close();
        return file;
    }

    @Test
    void journalWithoutAVersionIsRefusedInWordsAndReadAsEver() throws Exception {
        Path file = journal(Map.of());

        assertThatThrownBy(() -> SqliteJournal.open(file, JournalOptions.DEFAULT))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining("old.journal")
                .hasMessageContaining("other rules of firing (version 1, this one's is " + RuleVersion.CURRENT + ")")
                .hasMessageContaining("crw journal");
        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.header().project()).isEqualTo("{}");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "3", "x"})
    void journalOfAnotherVersionIsRefusedInWords(String version) throws Exception {
        Path file = journal(Map.of(RuleVersion.SETTING, version));

        assertThatThrownBy(() -> SqliteJournal.open(file, JournalOptions.DEFAULT))
                .hasMessageContaining("version " + version);
    }

    @Test
    void journalOfThisProgramIsGoneOnWith() throws Exception {
        Path file = folder.resolve("present.journal");
        JournalHeader header = JournalHeader.of("{}", Map.of(), Map.of("seed", "7"));
        SqliteJournal.create(file, header, JournalOptions.DEFAULT).close();

        try (SqliteJournal journal = SqliteJournal.open(file, JournalOptions.DEFAULT)) {
            assertThat(journal.header().settings())
                    .containsEntry("seed", "7")
                    .containsEntry(RuleVersion.SETTING, Integer.toString(RuleVersion.CURRENT));
        }
    }
}
