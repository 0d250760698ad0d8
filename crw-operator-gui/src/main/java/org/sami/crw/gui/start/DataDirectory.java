package org.sami.crw.gui.start;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Optional;
import org.sami.spn.journal.PrivateFiles;
import org.sami.ui.window.DirectoryLock;

/**
 * Where a window keeps what outlives it: journals of sessions, the arrangement of panels, settings. One process has it at a time, held by a
 * lock of the operating system, which ends with the process.
 */
public final class DataDirectory implements AutoCloseable {
    private static final DateTimeFormatter NAME = DateTimeFormatter.ofPattern("yyyy-MM-dd_HH-mm-ss");

    private static final int MOST_REPLAYS = 9;

    private final Path folder;
    private final DirectoryLock lock;
    private final OpenSession openSession;
    private Optional<String> trouble = Optional.empty();

    private DataDirectory(Path folder, DirectoryLock lock) {
        this.folder = folder;
        this.lock = lock;
        openSession = new OpenSession(folder, folder.resolve("sessions"));
    }

    /**
     * Opens it; makes it where it is not there.
     *
     * @throws IOException if another process has it, which the message names with the lock, or it cannot be made
     */
    public static DataDirectory open(Path folder) throws IOException {
        Optional<DirectoryLock> lock = DirectoryLock.take(folder);
        if (lock.isEmpty()) {
            throw new IOException("another window uses " + folder.toAbsolutePath() + " (lock: "
                    + DirectoryLock.fileIn(folder) + "); close it, or give this one a folder of its own: --data DIR");
        }
        PrivateFiles.makeOwnFolder(folder.resolve("sessions"));
        return new DataDirectory(folder, lock.get());
    }

    /**
     * Opens a directory for the window of a replay, below the one of sessions: of several replays at once each has its own.
     *
     * @throws IOException if it cannot be made, or there are too many
     */
    public static DataDirectory openForReplay(Path folder) throws IOException {
        return openOneOf(folder, "replay", "there are too many replays");
    }

    /**
     * As {@link #openForReplay}, for a window over a session in another process.
     *
     * @throws IOException as there
     */
    public static DataDirectory openForSessionElsewhere(Path folder) throws IOException {
        return openOneOf(folder, "elsewhere", "there are too many windows over sessions elsewhere");
    }

    private static DataDirectory openOneOf(Path folder, String name, String tooMany) throws IOException {
        IOException taken = new IOException(tooMany);
        for (int i = 1; i <= MOST_REPLAYS; i++) {
            try {
                return open(folder.resolve(i == 1 ? name : name + "-" + i));
            } catch (IOException held) {
                taken = held;
            }
        }
        throw taken;
    }

    /** The directory of a person who names none, by the XDG rules. */
    public static Path ofUser() {
        return DirectoryLock.ofUser("operator");
    }

    /** The file of the arrangement of panels. */
    public Path arrangement() {
        return folder.resolve("arrangement.xml");
    }

    /** The file of settings. */
    public Path settings() {
        return folder.resolve("window.properties");
    }

    /** A file for the journal of a session that begins now; it is the open one until {@link #finished}. */
    public Path newJournal() throws IOException {
        Path sessions = folder.resolve("sessions");
        String name = LocalDateTime.now(ZoneId.systemDefault()).format(NAME);
        Path journal = sessions.resolve(name + ".journal");
        for (int i = 2; Files.exists(journal); i++) {
            journal = sessions.resolve(name + "-" + i + ".journal");
        }
        openSession.write(journal);
        return journal;
    }

    /**
     * The journal of a session that was not finished. Where the file that names it is damaged, that one is set aside, {@link #trouble} says so, and the newest
     * journal is taken for it.
     */
    public Optional<Path> unfinished() throws IOException {
        OpenSession.Entry entry = openSession.read();
        if (!entry.trouble().isEmpty()) {
            trouble = Optional.of(entry.trouble());
        }
        return entry.journal();
    }

    /** What was wrong with the file that names the unfinished session, when {@link #unfinished} looked; one sentence without a full stop. */
    public Optional<String> trouble() {
        return trouble;
    }

    /** The session that was open is over: nobody is offered it again. */
    public void finished() throws IOException {
        openSession.delete();
    }

    /** The directory itself. */
    public Path folder() {
        return folder;
    }

    @Override
    public void close() throws IOException {
        lock.close();
    }
}
