package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.host.JournalException;

/** A journal that somebody else has prepared runs nothing; and one of ours is read by its user only. */
class ForeignJournalTest {
    @TempDir
    private Path folder;

    private Path journal() throws IOException {
        Path file = folder.resolve("session.journal");
        SqliteJournal.create(file, Tour.HEADER, JournalOptions.DEFAULT).close();
        return file;
    }

    private static void run(Path file, String sql) throws SQLException {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + file);
                Statement statement = connection.createStatement()) {
            for (String one : sql.split(";;")) {
                statement.execute(one);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "CREATE VIEW spy AS SELECT * FROM entries",
                "ALTER TABLE telemetry RENAME TO hidden;;"
                        + "CREATE VIEW telemetry AS SELECT pos, at_millis, proxy, kind, json, sum FROM hidden",
                "CREATE TRIGGER t AFTER INSERT ON telemetry BEGIN DELETE FROM entries; END",
                "CREATE TABLE extra (x)",
                "CREATE INDEX i ON entries(at_millis)",
                "CREATE VIRTUAL TABLE v USING fts5(x)",
                "ALTER TABLE telemetry ADD COLUMN y TEXT AS (upper(json))",
                "DROP TABLE marks;;CREATE TABLE marks (idx INTEGER PRIMARY KEY, mark TEXT CHECK (length(mark) > 0),"
                        + " checksum BLOB)"
            })
    void fileWithMoreThanAJournalHasIsRefusedByAllWhoReadIt(String sql) throws Exception {
        Path file = journal();
        run(file, sql);
        byte[] before = Files.readAllBytes(file);

        assertThatThrownBy(() -> SqliteJournal.open(file, JournalOptions.DEFAULT))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining("is none that this program wrote: it has a ");
        assertThatThrownBy(() -> JournalReader.open(file))
                .isInstanceOf(JournalException.class)
                .hasMessageContaining("is none that this program wrote: it has a ");
        assertThat(Files.readAllBytes(file)).isEqualTo(before);
    }

    @Test
    void journalAndAllBesideItAreReadByTheirUserOnly() throws Exception {
        assumeThat(FileSystems.getDefault().supportedFileAttributeViews()).contains("posix");
        Path file = folder.resolve("session.journal");
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, JournalOptions.DEFAULT)) {
            journal.addTelemetry(List.of(new TelemetryRow(1, "", "x", "{}")));
            assertThat(permissions()).isNotEmpty().containsOnly("rw-------");
            assertThat(Files.exists(Database.log(file))).isTrue();
        }
    }

    @Test
    void journalOfAnEarlierVersionIsReadByItsUserOnlyOnceItIsGoneOnWith() throws Exception {
        assumeThat(FileSystems.getDefault().supportedFileAttributeViews()).contains("posix");
        Path file = journal();
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r--r--"));
        try (SqliteJournal journal = SqliteJournal.open(file, JournalOptions.DEFAULT)) {
            journal.addTelemetry(List.of(new TelemetryRow(1, "", "x", "{}")));
            assertThat(permissions()).containsOnly("rw-------");
        }
    }

    @Test
    void foldersAreMadePrivateAndOwnOnesBecomeSo() throws Exception {
        assumeThat(FileSystems.getDefault().supportedFileAttributeViews()).contains("posix");
        Path made = folder.resolve("a/b");
        PrivateFiles.makeFolder(made);
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(made)))
                .isEqualTo("rwx------");
        Files.setPosixFilePermissions(made, PosixFilePermissions.fromString("rwxr-xr-x"));
        PrivateFiles.makeFolder(made);
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(made)))
                .as("others may use it")
                .isEqualTo("rwxr-xr-x");
        PrivateFiles.makeOwnFolder(made);
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(made)))
                .isEqualTo("rwx------");
    }

    private List<String> permissions() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            List<Path> all = files.toList();
            List<String> permissions = new ArrayList<>();
            for (Path one : all) {
                permissions.add(PosixFilePermissions.toString(Files.getPosixFilePermissions(one)));
            }
            return permissions;
        }
    }
}
