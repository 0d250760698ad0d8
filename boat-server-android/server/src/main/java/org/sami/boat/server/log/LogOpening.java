package org.sami.boat.server.log;

import java.io.Closeable;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Path;
import java.util.SortedMap;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.server.RememberedCommand;

/** A boat's log that was found at a start, locked against other processes and read. */
final class LogOpening implements Closeable {
    private final LogFiles files;
    private final CarriedState state;
    private final FileChannel lock;
    private final FileChannel newest;
    private final int number;
    private final LogExtent extent;
    private final int unreadLines;

    private LogOpening(
            LogFiles files,
            CarriedState state,
            FileChannel lock,
            FileChannel newest,
            int number,
            LogExtent extent,
            int unreadLines) {
        this.files = files;
        this.state = state;
        this.lock = lock;
        this.newest = newest;
        this.number = number;
        this.extent = extent;
        this.unreadLines = unreadLines;
    }

    /**
     * Locks and reads a log, and takes away a last line that was cut off.
     *
     * @throws IOException if it cannot be read, is no boat's log, or another process writes it
     */
    static LogOpening of(LogDisk disk, LogFiles files, LogEntries earlier) throws IOException {
        Path first = files.file(0);
        FileChannel lock = disk.open(first.resolveSibling(first.getFileName() + ".lock"));
        try {
            lock(lock, first);
            return read(disk, files, lock, earlier);
        } catch (IOException | RuntimeException e) {
            lock.close();
            throw e;
        }
    }

    private static void lock(FileChannel channel, Path file) throws IOException {
        try {
            FileLock lock = channel.tryLock();
            if (lock != null) {
                return; // until the channel closes
            }
        } catch (OverlappingFileLockException e) {
            // this process has it
        }
        throw new IOException(file + " is being written by another boat server");
    }

    /** Reads from the newest file that begins with all that is needed: where a disk has lost the end of a head, the files before it say the rest. */
    private static LogOpening read(LogDisk disk, LogFiles files, FileChannel lock, LogEntries earlier)
            throws IOException {
        SortedMap<Integer, Path> all = files.byNumber();
        int number = all.isEmpty() ? 0 : all.lastKey();
        int from = number;
        while (!all.headMap(from).isEmpty() && !LogLines.isHeadWhole(files.file(from))) {
            from = all.headMap(from).lastKey();
        }
        CarriedState state = new CarriedState();
        LogEntries both = new Both(earlier, state);
        FileChannel newest = disk.open(files.file(number));
        try {
            int unread = 0;
            for (Path before : all.tailMap(from).headMap(number).values()) {
                unread += LogLines.read(before, both).unreadLines();
            }
            LogExtent extent = LogLines.read(files.file(number), both);
            newest.truncate(extent.wholeBytes());
            newest.position(extent.wholeBytes());
            return new LogOpening(files, state, lock, newest, number, extent, unread + extent.unreadLines());
        } catch (IOException | RuntimeException e) {
            newest.close();
            throw e;
        }
    }

    LogFiles files() {
        return files;
    }

    /** What a restarted boat needs of all that was read. */
    CarriedState state() {
        return state;
    }

    /** Keeps other processes from the log while it is open. */
    FileChannel lock() {
        return lock;
    }

    /** The newest file, at its end. */
    FileChannel newest() {
        return newest;
    }

    /** Its number. */
    int number() {
        return number;
    }

    /** What was found in it. */
    LogExtent extent() {
        return extent;
    }

    /** Lines that say nothing, of all files that were read. */
    int unreadLines() {
        return unreadLines;
    }

    @Override
    public void close() throws IOException {
        try {
            newest.close();
        } finally {
            lock.close();
        }
    }

    /** Hands on what stands in the log, and keeps it for the next file. */
    private static final class Both implements LogEntries {
        private final LogEntries one;
        private final LogEntries other;

        Both(LogEntries one, LogEntries other) {
            this.one = one;
            this.other = other;
        }

        @Override
        public void answered(LoggedCommand entry) {
            one.answered(entry);
            other.answered(entry);
        }

        @Override
        public void remembered(RememberedCommand command) {
            one.remembered(command);
            other.remembered(command);
        }

        @Override
        public void inForce(String clientId, CommandMessage command) {
            one.inForce(clientId, command);
            other.inForce(clientId, command);
        }
    }
}
