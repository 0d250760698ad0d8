package org.sami.spn.journal;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.sami.spn.host.JournalException;

/**
 * The right to write a journal: a lock on a file next to it, so that reading stays free to everybody, and one on a byte of the
 * journal itself, far behind its end, which keeps out who comes by another name (a hard link has a lock file, and a
 * write-ahead log, of its own). The system gives both back when the process dies; the empty file stays. Within one process
 * a set keeps the second writer out, because there closing any handle of a file would end its locks (docs/session.md).
 */
final class JournalLock implements AutoCloseable {
    /** Behind all that SQLite locks (from 1 GiB) or ever writes. */
    private static final long FAR_BEHIND = Long.MAX_VALUE - 1;

    private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();

    /** The files that are held, by identity, with the names by which they are. */
    private static final Map<Object, Path> HELD_FILES = new ConcurrentHashMap<>();

    private final Path key;
    private final FileChannel channel;
    private Optional<Object> identity = Optional.empty();
    private Path heldAs;
    private Optional<FileChannel> own = Optional.empty();

    private JournalLock(Path key, FileChannel channel) {
        this.key = key;
        heldAs = key;
        this.channel = channel;
    }

    /** The file that a name leads to: SQLite keeps its log next to that file, and not next to a symbolic link. */
    static Path file(Path journal) throws IOException {
        return Files.isSymbolicLink(journal) && Files.exists(journal) ? journal.toRealPath() : journal;
    }

    /** Takes the right to write a journal of this name, which need not exist yet. */
    static JournalLock take(Path journal) throws IOException {
        Path key = lockFile(named(journal));
        if (!HELD.add(key)) {
            throw new JournalException(journal, 0, "is being written already, by this program");
        }
        FileChannel channel = null;
        try {
            PrivateFiles.makeFile(key);
            channel = FileChannel.open(key, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
            FileLock lock = channel.tryLock();
            if (lock == null) {
                throw new JournalException(journal, 0, "is being written already, by another process");
            }
            return new JournalLock(key, channel);
        } catch (IOException fault) {
            HELD.remove(key);
            if (channel != null) {
                channel.close();
            }
            throw fault instanceof JournalException
                    ? fault
                    : new JournalException(journal, 0, "cannot be locked: " + fault.getMessage(), fault);
        }
    }

    /** Takes the right to the file that now has the journal's name: when it is there, and again when it was replaced. */
    void takeFile(Path journal) throws IOException {
        leaveFile();
        Optional<Object> found = identity(journal);
        if (found.isPresent() && !hold(found.get(), journal)) {
            throw new JournalException(journal, 0, "is being written already, by this program under another name");
        }
        identity = found;
        heldAs = journal;
        boolean free;
        try {
            FileChannel itself = FileChannel.open(journal, StandardOpenOption.READ, StandardOpenOption.WRITE);
            own = Optional.of(itself);
            free = itself.tryLock(FAR_BEHIND, 1, false) != null;
        } catch (IOException fault) {
            throw new JournalException(journal, 0, "cannot be locked: " + fault.getMessage(), fault);
        }
        if (!free) {
            throw new JournalException(journal, 0, "is being written already, by another process under another name");
        }
    }

    /** Holds a file. Once a file that is held is gone, the system may give its identity to a new one, which nobody holds. */
    private static boolean hold(Object file, Path journal) throws IOException {
        Path holder = HELD_FILES.putIfAbsent(file, journal);
        return holder == null || (!isHeld(file) && HELD_FILES.replace(file, holder, journal));
    }

    private static boolean isHeld(Object file) throws IOException {
        Path holder = HELD_FILES.get(file);
        return holder != null && Files.exists(holder) && identity(holder).equals(Optional.of(file));
    }

    /**
     * Refuses to read a journal that is being written under another name: what this name shows is not what is true.
     *
     * @throws JournalException if it is
     */
    static void checkName(Path name) throws JournalException {
        try {
            Path journal = file(name);
            Optional<Object> found = identity(journal);
            if (!hasOtherNames(journal) || HELD.contains(lockFile(named(journal)))) {
                return;
            }
            if ((found.isPresent() && isHeld(found.get()))
                    || (isLocked(journal, FAR_BEHIND) && !isLocked(lockFile(journal), 0))) {
                throw new JournalException(name, 0, "is being written under another name: read it by that name");
            }
        } catch (JournalException refused) {
            throw refused;
        } catch (IOException | UnsupportedOperationException unknown) {
            System.getLogger(JournalLock.class.getName())
                    .log(System.Logger.Level.DEBUG, "names of {0} are not known: {1}", name, unknown.getMessage());
        }
    }

    private static boolean hasOtherNames(Path journal) throws IOException {
        return Files.getAttribute(journal, "unix:nlink") instanceof Integer names && names > 1;
    }

    private static boolean isLocked(Path file, long position) throws IOException {
        if (!Files.exists(file)) {
            return false;
        }
        try (FileChannel probe = FileChannel.open(file, StandardOpenOption.READ, StandardOpenOption.WRITE);
                FileLock free = probe.tryLock(position, 1, false)) {
            return free == null;
        }
    }

    private static Optional<Object> identity(Path journal) throws IOException {
        return Optional.ofNullable(
                Files.readAttributes(journal, BasicFileAttributes.class).fileKey());
    }

    private static Path named(Path journal) throws IOException {
        Path absolute = journal.toAbsolutePath().normalize();
        Path folder = absolute.getParent();
        return folder != null && Files.isDirectory(folder)
                ? folder.toRealPath().resolve(absolute.getFileName())
                : absolute;
    }

    static Path lockFile(Path journal) {
        return journal.resolveSibling(journal.getFileName() + "-lock");
    }

    private void leaveFile() throws IOException {
        if (own.isPresent()) {
            own.get().close();
        }
        own = Optional.empty();
        identity.ifPresent(file -> HELD_FILES.remove(file, heldAs));
        identity = Optional.empty();
    }

    /** Gives the right back; to be called when no handle of the journal is open any more. */
    @Override
    public void close() throws IOException {
        leaveFile();
        channel.close();
        HELD.remove(key);
    }
}
