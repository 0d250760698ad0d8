package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.sami.spn.host.HostPlans.number;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;
import org.sami.spn.protocol.Input;

/** Projects that were loaded during a session, in its journal: each document once, and damage to one is seen. */
class ProjectDocumentsTest {
    private static final Input FIRST = new Input.LoadProject("{\"id\": \"one\", \"name\": \"Käse 海\"}\n");
    private static final Input SECOND = new Input.LoadProject("{\"id\": \"two\"}\n");
    private static final List<JournalEntry> ENTRIES = List.of(
            new JournalEntry(1, 10, number(1)),
            new JournalEntry(2, 20, FIRST),
            new JournalEntry(3, 30, SECOND),
            new JournalEntry(4, 40, number(4)),
            new JournalEntry(5, 50, FIRST));

    @TempDir
    Path folder;

    private Path file() {
        return folder.resolve("session.journal");
    }

    private void write() throws IOException {
        try (SqliteJournal journal = SqliteJournal.create(file(), Tour.HEADER, JournalOptions.DEFAULT)) {
            journal.append(ENTRIES.subList(0, 1), Durability.PROCESS);
            journal.append(ENTRIES.subList(1, 5), Durability.PROCESS);
        }
    }

    @Test
    void entriesThatLoadComeBackWithTheirDocuments() throws Exception {
        write();

        try (JournalReader reader = JournalReader.open(file())) {
            assertThat(reader.entries()).isEqualTo(ENTRIES);
            assertThat(reader.recovery().damage()).isEmpty();
        }
        try (SqliteJournal again = SqliteJournal.open(file(), JournalOptions.DEFAULT)) {
            assertThat(again.lastIndex()).isEqualTo(5);
            assertThat(again.recovery().damage()).isEmpty();
        }
    }

    @Test
    void anEqualDocumentIsStoredOnce() throws Exception {
        write();

        assertThat(count("SELECT count(*) FROM documents")).isEqualTo(2);
        assertThat(count("SELECT max(length(input)) FROM entries WHERE input LIKE '%load-project%'"))
                .isLessThan(120);
    }

    @Test
    void aSessionThatLoadsNothingHasNoTableOfDocuments() throws Exception {
        try (SqliteJournal journal = SqliteJournal.create(file(), Tour.HEADER, JournalOptions.DEFAULT)) {
            journal.append(ENTRIES.subList(0, 1), Durability.PROCESS);
        }

        assertThat(count("SELECT count(*) FROM sqlite_master WHERE name = 'documents'"))
                .isZero();
    }

    @Test
    void theJournalIsTrueUpToTheEntryWhoseDocumentIsDamaged() throws Exception {
        write();
        change("UPDATE documents SET content = 'other' WHERE content LIKE '%two%'");

        try (JournalReader reader = JournalReader.open(file())) {
            assertThat(reader.entries()).isEqualTo(ENTRIES.subList(0, 2));
            assertThat(reader.recovery().damage())
                    .hasValueSatisfying(
                            what -> assertThat(what).contains("entry 3").contains("project"));
        }
    }

    @Test
    void aJournalWrittenAnewKeepsTheDocumentsOfItsEntries() throws Exception {
        write();
        change("DELETE FROM documents WHERE content LIKE '%two%'");

        try (SqliteJournal journal = SqliteJournal.open(file(), JournalOptions.DEFAULT)) {
            assertThat(journal.lastIndex()).isEqualTo(2);
            assertThat(journal.recovery().damage()).isPresent();
            journal.append(List.of(new JournalEntry(3, 60, SECOND)), Durability.PROCESS);
        }
        try (JournalReader reader = JournalReader.open(file())) {
            assertThat(reader.recovery().damage()).isEmpty();
            assertThat(reader.entries()).extracting(JournalEntry::input).containsExactly(number(1), FIRST, SECOND);
        }
    }

    @Test
    void documentsThatCannotBeReadAreAFaultAndNoTableIsNone() throws Exception {
        write();
        try (JournalReader reader = JournalReader.open(file())) {
            assertThat(reader.documents()).hasSize(2);

            alter("ALTER TABLE documents RENAME COLUMN content TO other");
            assertThatThrownBy(reader::documents)
                    .isInstanceOf(JournalException.class)
                    .hasMessageContaining("has documents that cannot be read");

            alter("DROP TABLE documents");
            assertThat(reader.documents()).isEmpty();
        }
    }

    private void alter(String sql) throws SQLException {
        try (Connection connection = connection();
                Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }

    private Connection connection() throws SQLException {
        return DriverManager.getConnection("jdbc:sqlite:" + file());
    }

    private long count(String sql) throws SQLException {
        try (Connection connection = connection();
                Statement statement = connection.createStatement();
                ResultSet rows = statement.executeQuery(sql)) {
            return rows.getLong(1);
        }
    }

    private void change(String sql) throws SQLException {
        try (Connection connection = connection();
                Statement statement = connection.createStatement()) {
            assertThat(statement.executeUpdate(sql)).isPositive();
        }
    }
}
