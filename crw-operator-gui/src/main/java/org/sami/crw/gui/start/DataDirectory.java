package org.sami.crw.gui.start;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Optional;

/**
 * Where a window keeps what outlives it: journals of sessions, the arrangement of panels, settings. One process has it at a time, held by a
 * lock of the operating system, which ends with the process.
 */
public final class DataDirectory implements AutoCloseable {
    private static final DateTimeFormatter NAME = DateTimeFormatter.ofPattern("yyyy-MM-dd_HH-mm-ss");

    private static final int MOST_REPLAYS = 9;

    private final Path folder;
    private final FileChannel channel;

    private DataDirectory(Path folder, FileChannel channel) {
        this.folder = folder;
        this.channel = channel;
    }

    /**
     * Opens it; makes it where it is not there.
     *
     * @throws IOException if another process has it, which the message names with the lock, or it cannot be made
     */
    public static DataDirectory open(Path folder) throws IOException {
        Files.createDirectories(folder.resolve("sessions"));
        Path lock = folder.resolve("lock");
        FileChannel channel =
                FileChannel.open(lock, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
        if (tryLock(channel).isEmpty()) {
            channel.close();
            throw new IOException("another window uses " + folder.toAbsolutePath() + " (lock: " + lock.toAbsolutePath()
                    + "); close it, or give this one a folder of its own: --data DIR");
        }
        return new DataDirectory(folder, channel);
    }

    /**
     * Opens a directory for the window of a replay, below the one of sessions: of several replays at once each has its own.
     *
     * @throws IOException if it cannot be made, or there are too many
     */
    public static DataDirectory openForReplay(Path folder) throws IOException {
        IOException taken = new IOException("there are too many replays");
        for (int i = 1; i <= MOST_REPLAYS; i++) {
            try {
                return open(folder.resolve(i == 1 ? "replay" : "replay-" + i));
            } catch (IOException held) {
                taken = held;
            }
        }
        throw taken;
    }

    private static Optional<FileLock> tryLock(FileChannel channel) throws IOException {
        try {
            return Optional.ofNullable(channel.tryLock());
        } catch (OverlappingFileLockException thisProcess) {
            return Optional.empty();
        }
    }

    /** The directory of a person who names none, by the XDG rules. */
    public static Path ofUser() {
        String data = System.getenv("XDG_DATA_HOME");
        return data == null || data.isBlank()
                ? Path.of(System.getProperty("user.home"), ".local", "share", "sami", "operator")
                : Path.of(data, "sami", "operator");
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
        Files.writeString(open(), journal.getFileName().toString());
        return journal;
    }

    /** The journal of a session that was not finished. */
    public Optional<Path> unfinished() throws IOException {
        if (!Files.exists(open())) {
            return Optional.empty();
        }
        Path journal =
                folder.resolve("sessions").resolve(Files.readString(open()).strip());
        return Optional.of(journal).filter(Files::isRegularFile);
    }

    /** The session that was open is over: nobody is offered it again. */
    public void finished() throws IOException {
        Files.deleteIfExists(open());
    }

    /** The directory itself. */
    public Path folder() {
        return folder;
    }

    private Path open() {
        return folder.resolve("open-session");
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
