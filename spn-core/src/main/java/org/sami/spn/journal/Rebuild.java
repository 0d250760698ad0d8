package org.sami.spn.journal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.spn.host.JournalException;
import org.sami.spn.protocol.Input;

/**
 * Makes journal files: new ones, and the valid part of a damaged one again. Writing on into a file whose structure is
 * damaged could spoil what is still true in it; so that part is copied, the damaged files are kept, and the copy takes
 * their place by a rename (docs/decisions 0032).
 */
final class Rebuild {
    private Rebuild() {}

    /**
     * A new file with nothing but a header, folded into one file and synced. It gets its name only when it is whole: a
     * process that is killed before leaves no journal, rather than one that nobody can go on with.
     */
    static Contents begin(Path file, JournalHeader header, JournalOptions options) throws IOException {
        if (Files.exists(file)) {
            throw new JournalException(file, 0, "exists already; a journal is never written over");
        }
        Path unborn = file.resolveSibling(file.getFileName() + "-new");
        deleteWithLog(unborn);
        Checksum checksum;
        try (Database database = Database.create(unborn, options)) {
            checksum = HeaderTable.write(database.connection(), header);
            finish(database);
        } catch (SQLException fault) {
            deleteWithLog(unborn);
            throw new JournalException(file, 0, "cannot be written: " + fault.getMessage(), fault);
        }
        Files.move(unborn, file, StandardCopyOption.ATOMIC_MOVE);
        return new Contents(header, 0, 0, checksum, new TreeMap<>(), new TreeMap<>(), Optional.empty());
    }

    /**
     * Puts a journal of the valid entries in the place of a damaged one; closes the damaged one.
     */
    static Rebuilt of(Database damaged, Contents valid, JournalOptions options) throws IOException {
        Path file = damaged.file();
        Path copy = file.resolveSibling(file.getFileName() + "-rebuilt");
        deleteWithLog(copy);
        Telemetry telemetry = new TelemetryScan(damaged).run();
        try (Database rebuilt = Database.create(copy, options)) {
            HeaderTable.write(rebuilt.connection(), valid.header());
            copyEntries(damaged, rebuilt.connection(), valid.lastValid());
            copyAttachments(damaged, rebuilt.connection(), valid);
            copyTelemetry(telemetry, rebuilt.connection());
            finish(rebuilt);
        } catch (SQLException fault) {
            deleteWithLog(copy);
            throw new JournalException(file, 0, "cannot be rewritten: " + fault.getMessage(), fault);
        }
        Path kept = keep(file);
        closeDamaged(damaged);
        // First the log, and only then the rename: SQLite would apply an old log to the new file.
        Files.deleteIfExists(Database.log(file));
        Files.deleteIfExists(file.resolveSibling(file.getFileName() + "-shm"));
        Files.move(copy, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        return new Rebuilt(kept, telemetry.damage());
    }

    /**
     * What came of it.
     *
     * @param kept where the damaged file is kept
     * @param telemetryDamage which telemetry is lost, in words
     */
    record Rebuilt(Path kept, Optional<String> telemetryDamage) {}

    private static void finish(Database database) throws SQLException {
        database.connection().commit();
        database.connection().setAutoCommit(true);
        database.checkpoint();
    }

    private static void copyEntries(Database from, Connection to, long last) throws SQLException {
        ProjectDocuments old = new ProjectDocuments(from.connection());
        ProjectDocuments fresh = new ProjectDocuments(to);
        try (PreparedStatement select = from.connection()
                        .prepareStatement(
                                "SELECT idx, at_millis, input, checksum FROM entries WHERE idx <= ? ORDER BY idx");
                PreparedStatement insert = to.prepareStatement("INSERT INTO entries VALUES (?, ?, ?, ?)")) {
            select.setLong(1, last);
            try (ResultSet rows = select.executeQuery()) {
                while (rows.next()) {
                    insert.setLong(1, rows.getLong(1));
                    insert.setLong(2, rows.getLong(2));
                    insert.setString(3, rows.getString(3));
                    insert.setBytes(4, rows.getBytes(4));
                    insert.executeUpdate();
                    Optional<String> document =
                            InputText.documentOf(rows.getString(3)).flatMap(old::find);
                    if (document.isPresent()) {
                        fresh.makeTable();
                        fresh.add(new Input.LoadProject(document.get()));
                    }
                }
            }
        }
    }

    private static void copyAttachments(Database from, Connection to, Contents valid) throws SQLException {
        Attachments old = new Attachments(from.connection());
        Attachments fresh = new Attachments(to);
        for (var snapshot : valid.snapshots().entrySet()) {
            Optional<byte[]> state = old.snapshot(snapshot.getKey(), snapshot.getValue());
            if (state.isPresent()) {
                fresh.writeSnapshot(snapshot.getKey(), snapshot.getValue(), state.get());
            }
        }
        for (var mark : valid.marks().entrySet()) {
            Optional<String> text = old.mark(mark.getKey(), mark.getValue());
            if (text.isPresent()) {
                fresh.writeMark(mark.getKey(), mark.getValue(), text.get());
            }
        }
    }

    /** As much as can be read: readings change no state. */
    private static void copyTelemetry(Telemetry telemetry, Connection to) throws SQLException {
        try (PreparedStatement insert = TelemetryTable.insertion(to)) {
            for (TelemetryRow row : telemetry.rows()) {
                TelemetryTable.insert(insert, row);
            }
        }
    }

    private static Path keep(Path file) throws IOException {
        Path kept = file.resolveSibling(file.getFileName() + ".damaged");
        for (int n = 2; Files.exists(kept); n++) {
            kept = file.resolveSibling(file.getFileName() + ".damaged-" + n);
        }
        Files.copy(file, kept);
        Path log = Database.log(file);
        if (Files.exists(log)) {
            Files.copy(log, Database.log(kept), StandardCopyOption.REPLACE_EXISTING);
        }
        return kept;
    }

    private static void closeDamaged(Database damaged) {
        try {
            damaged.close();
        } catch (JournalException expected) {
            // Folding its log may well fail; the file is kept as it was and replaced here.
            System.getLogger(Rebuild.class.getName())
                    .log(System.Logger.Level.DEBUG, "closing the damaged journal: {0}", expected.getMessage());
        }
    }

    private static void deleteWithLog(Path file) throws IOException {
        Files.deleteIfExists(Database.log(file));
        Files.deleteIfExists(file.resolveSibling(file.getFileName() + "-shm"));
        Files.deleteIfExists(file);
    }
}
