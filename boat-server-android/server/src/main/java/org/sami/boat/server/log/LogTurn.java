package org.sami.boat.server.log;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A change to a new file of the log. Another thread than the boat's writes the file's head and forces it to the disk; new lines are collected meanwhile. Then
 * the boat's thread adds these lines and renames the file. Until then it is a {@code .part} file, which the next start removes.
 */
final class LogTurn {
    private final LogDisk disk;
    private final LogFiles files;
    private final int number;
    private final String bootId;
    private final List<String> meanwhile = new ArrayList<>(); // for the boat's thread
    private int repeated; // for the boat's thread
    private long bytes;
    private Optional<FileChannel> channel = Optional.empty(); // this and the next are handed on by the last one
    private Optional<IOException> fault = Optional.empty();
    private volatile boolean written;
    private boolean cancelled; // guarded by this

    LogTurn(LogDisk disk, LogFiles files, int number, String bootId) {
        this.bootId = bootId;
        this.disk = disk;
        this.files = files;
        this.number = number;
    }

    /** Writes the head; on another thread. */
    synchronized void write(CarriedState.LogHead head) {
        if (cancelled) {
            return;
        }
        try {
            byte[] content = head.text().getBytes(StandardCharsets.UTF_8);
            bytes = content.length;
            FileChannel made = disk.create(files.part(number));
            channel = Optional.of(made);
            disk.write(made, content);
            disk.force(made);
        } catch (IOException e) {
            fault = Optional.of(e);
        } catch (RuntimeException e) {
            fault = Optional.of(new IOException("a new file of the log cannot be written: " + e, e));
        } finally {
            written = true;
        }
    }

    /** Whether the head has come to the disk, or cannot. */
    boolean isWritten() {
        return written;
    }

    /**
     * A line that was added after the state of the head.
     *
     * @param inFileBefore whether it stands in the file before as well; none does after one that does not
     */
    void add(String line, boolean inFileBefore) {
        meanwhile.add(line);
        repeated += inFileBefore ? 1 : 0;
    }

    /**
     * Makes it the newest file of the log, once it is written.
     *
     * @return to write to, at its end
     * @throws IOException if it cannot be: the file before it stays the newest, and nothing is left of this one
     */
    FileChannel finish() throws IOException {
        try {
            if (fault.isPresent()) {
                throw fault.get();
            }
            FileChannel made = channel.orElseThrow(() -> new IllegalStateException("it is not written"));
            if (repeated > 0) {
                meanwhile.add(0, LogLines.repeats(bootId, repeated));
            }
            for (String line : meanwhile) {
                disk.write(made, line.getBytes(StandardCharsets.UTF_8));
            }
            disk.rename(files.part(number), file());
            return made;
        } catch (IOException e) {
            abandon();
            throw e;
        }
    }

    /** Gives it up; waits for the other thread where it is at work. */
    synchronized void cancel() {
        cancelled = true;
        abandon();
    }

    private void abandon() {
        try {
            if (channel.isPresent()) {
                channel.get().close();
            }
            disk.delete(files.part(number));
        } catch (IOException left) {
            // the next start removes it
        }
    }

    /** The file that it becomes. */
    Path file() {
        return files.file(number);
    }

    /** Its number. */
    int number() {
        return number;
    }

    /** Length of the head. */
    long headBytes() {
        return bytes;
    }
}
