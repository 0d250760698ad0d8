package org.sami.ui.window;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import org.sami.spn.journal.PrivateFiles;

/** Holds a folder for one process at a time, by a lock of the operating system, which ends with the process. */
public final class DirectoryLock implements AutoCloseable {
    private static final String FILE = "lock";

    private final FileChannel channel;

    private DirectoryLock(FileChannel channel) {
        this.channel = channel;
    }

    /**
     * Takes a folder, which is made, for its user only, where it is not there; empty where another has it.
     *
     * @throws IOException if the folder cannot be made or written to
     */
    public static Optional<DirectoryLock> take(Path folder) throws IOException {
        PrivateFiles.makeFolder(folder);
        FileChannel channel = FileChannel.open(
                fileIn(folder), StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
        if (tryLock(channel).isEmpty()) {
            channel.close();
            return Optional.empty();
        }
        return Optional.of(new DirectoryLock(channel));
    }

    /** The file that is locked. */
    public static Path fileIn(Path folder) {
        return folder.resolve(FILE).toAbsolutePath();
    }

    /** The folder of a person's data that belongs to a program of SAMI, by the XDG rules. */
    public static Path ofUser(String program) {
        String data = System.getenv("XDG_DATA_HOME");
        return data == null || data.isBlank()
                ? Path.of(System.getProperty("user.home"), ".local", "share", "sami", program)
                : Path.of(data, "sami", program);
    }

    private static Optional<FileLock> tryLock(FileChannel channel) throws IOException {
        try {
            return Optional.ofNullable(channel.tryLock());
        } catch (OverlappingFileLockException thisProcess) {
            return Optional.empty();
        }
    }

    /** Gives the folder up. */
    @Override
    public void close() throws IOException {
        channel.close();
    }
}
