package org.sami.spn.journal;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The right to write a journal: a lock on a file beside it, so that reading stays free to everybody. The system gives it
 * back when the process dies, the empty file stays. Within one process a set keeps the second writer out, because there
 * closing any handle of the file would end the lock.
 */
final class JournalLock implements AutoCloseable {
    private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();

    private final Path key;
    private final FileChannel channel;

    private JournalLock(Path key, FileChannel channel) {
        this.key = key;
        this.channel = channel;
    }

    static JournalLock take(Path journal) throws IOException {
        Path key = lockFile(journal.toAbsolutePath().normalize());
        if (!HELD.add(key)) {
            throw new JournalException(journal, 0, "is being written already, by this program");
        }
        FileChannel channel = null;
        try {
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

    static Path lockFile(Path journal) {
        return journal.resolveSibling(journal.getFileName() + "-lock");
    }

    @Override
    public void close() throws IOException {
        channel.close();
        HELD.remove(key);
    }
}
