package org.sami.boat.server.log;

import java.io.Closeable;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.server.ServerLog;
import org.sami.boat.server.file.BoatFiles;

/**
 * A boat's log as text files with one line for each command, appended to over all starts. The operating system gets each line before the boat's answer
 * leaves, so that the death of the process loses no answered command; a line that was cut off is removed at the next opening. A loss of power can lose
 * the last seconds.
 *
 * <p>All files together have no more than a set size. An eighth of it is one file: then a new one begins with all that a restarted boat needs, and the
 * oldest go. A new file counts once it is whole on the disk; until then the boat writes to the one before.
 *
 * <p>Files that cannot be written do not stop the boat: it reports the fault once, goes on without a log, and tries to begin a new file from time to time.
 * For the thread that drives the boat.
 */
public final class CommandLogFile implements ServerLog, Closeable {
    /** Least size of a log in bytes. */
    public static final long LEAST_BYTES = 64 << 10;

    private static final int FILES = 8;
    private static final long RETRY_MS = 10_000;

    private final LogDisk disk;
    private final LogFiles files;
    private final long limitBytes;
    private final String bootId;
    private final Executor aside;
    private final LogFaults faults;
    private final CarriedState state;
    private final EpochFile epochFile;
    private final CommandEpoch epoch;
    private final FileChannel lock;
    private final int unreadLines;
    private final int restored;
    private FileChannel channel;
    private int number;
    private long bytes;
    private long headBytes;
    private Optional<LogTurn> turn = Optional.empty();
    private boolean unwritable;
    private boolean oversized;
    private long nextTurnMs = Long.MIN_VALUE;

    private CommandLogFile(
            LogDisk disk, Executor aside, long limitBytes, String bootId, LogFaults faults, LogOpening opened)
            throws IOException {
        this.disk = disk;
        this.aside = aside;
        this.limitBytes = limitBytes;
        this.bootId = Objects.requireNonNull(bootId, "bootId");
        this.faults = Objects.requireNonNull(faults, "faults");
        files = opened.files();
        state = opened.state();
        lock = opened.lock();
        epochFile = new EpochFile(files.file(0));
        epoch = epochFile.read();
        channel = opened.newest();
        number = opened.number();
        bytes = opened.extent().wholeBytes();
        headBytes = opened.extent().headBytes();
        unreadLines = opened.unreadLines();
        restored = state.size();
    }

    /**
     * Opens or creates a boat's log, reads what a restarted boat needs and adds the start of this server.
     *
     * @param place where it is; what a restarted boat needs is kept even if that has more than the bytes there
     * @param bootId names this start
     * @param earlier receives what the earlier starts have left, in order
     * @param faults gets to know when the log cannot be kept
     * @throws IOException if a file cannot be read or written, is no boat's log, or another process writes it
     */
    public static CommandLogFile open(LogPlace place, String bootId, LogEntries earlier, LogFaults faults)
            throws IOException {
        return open(new LogDisk(), LogAside.THREAD, place, bootId, earlier, faults);
    }

    static CommandLogFile open(
            LogDisk disk, Executor aside, LogPlace place, String bootId, LogEntries earlier, LogFaults faults)
            throws IOException {
        LogOpening opened = LogOpening.of(disk, new LogFiles(place.file()), earlier);
        try {
            CommandLogFile log = new CommandLogFile(disk, aside, place.limitBytes(), bootId, faults, opened);
            log.begin();
            return log;
        } catch (IOException | RuntimeException e) {
            opened.close();
            throw e;
        }
    }

    /** The log's files as clients may fetch them; nothing else of their folder, where other boats of this machine may have theirs. */
    public static BoatFiles files(Path file) {
        LogFiles files = new LogFiles(file);
        return BoatFiles.none().with(KeptFile.LOG, files.folder(), files::isOne);
    }

    private void begin() throws IOException {
        for (Path part : files.unfinished()) {
            disk.delete(part);
        }
        String start = LogLines.start(bootId);
        disk.write(channel, start.getBytes(StandardCharsets.UTF_8));
        bytes += start.length();
        if (number > 0
                && headBytes == 0) { // a disk has lost its head: the next one is whole before anything counts on it
            LogTurn whole = new LogTurn(disk, files, number + 1, bootId);
            whole.write(state.head(bootId));
            finish(whole);
        }
    }

    /** How many lines of the earlier starts said nothing, because they are damaged. */
    public int unreadLines() {
        return unreadLines;
    }

    /** How many commands of the earlier starts were given back, to be known or in force. */
    public int restored() {
        return restored;
    }

    @Override
    public void answered(long nowMs, String clientId, CommandMessage command, LinkMessage answer) {
        LoggedCommand entry = new LoggedCommand(bootId, nowMs, clientId, command, answer);
        state.answered(entry);
        add(nowMs, LogLines.command(entry));
    }

    /** Who commanded last in the earlier starts; {@link CommandEpoch#NONE} if nobody did. */
    public CommandEpoch epoch() {
        return epoch;
    }

    @Override
    public void appointed(CommandEpoch next) {
        try {
            epochFile.write(next);
        } catch (IOException e) {
            faults.unwritable(e); // the log itself may still be written
        }
    }

    @Override
    public void leftOut(long nowMs, long count) {
        add(nowMs, LogLines.leftOut(bootId, nowMs, count));
    }

    private void add(long nowMs, String line) {
        if (!unwritable) {
            write(line);
        }
        if (turn.isPresent()) {
            turn.get().add(line, !unwritable);
            if (turn.get().isWritten()) {
                finish(nowMs);
            }
        } else if (nowMs >= nextTurnMs && (unwritable || bytes >= fileBytes())) {
            LogTurn next = new LogTurn(disk, files, number + 1, bootId);
            CarriedState.LogHead head = state.head(bootId);
            turn = Optional.of(next);
            aside.execute(() -> next.write(head));
        }
    }

    /** A file grows to this length. A new one begins with room for as much as it carries, or the disk would do nothing else. */
    private long fileBytes() {
        return Math.max(limitBytes / FILES, 2 * headBytes);
    }

    /** A line of which only a part could be written is taken away: what follows it would be lost with it. */
    private void write(String line) {
        byte[] content = line.getBytes(StandardCharsets.UTF_8);
        try {
            disk.write(channel, content);
            bytes += content.length;
        } catch (IOException e) {
            reportUnwritable(e);
            try {
                channel.truncate(bytes);
            } catch (IOException closedOrBroken) {
                // the next start takes it away
            }
        }
    }

    private void reportUnwritable(IOException cause) {
        if (!unwritable) {
            unwritable = true;
            faults.unwritable(cause);
        }
    }

    private void finish(long nowMs) {
        LogTurn done = turn.orElseThrow(IllegalStateException::new);
        turn = Optional.empty();
        try {
            finish(done);
        } catch (IOException e) {
            nextTurnMs = nowMs + RETRY_MS;
            if (!oversized && !unwritable) {
                oversized = true;
                faults.oversized(e);
            }
        }
    }

    private void finish(LogTurn done) throws IOException {
        FileChannel before = channel;
        channel = done.finish();
        number = done.number();
        bytes = channel.position();
        headBytes = done.headBytes();
        try {
            before.close();
        } catch (IOException e) {
            // nothing more is written to it
        }
        long room =
                limitBytes - limitBytes / FILES - fileBytes(); // an eighth for what comes until the next one is there
        int newest = number;
        aside.execute(() -> removeOld(newest, room));
        if (unwritable || oversized) {
            unwritable = false;
            oversized = false;
            faults.mended();
        }
    }

    /** On another thread. The files before are needed until the name of the new one is on the disk. */
    private void removeOld(int newest, long room) {
        disk.forceFolder(files.folder());
        try {
            for (Path file : files.over(newest, room)) {
                disk.delete(file);
            }
        } catch (IOException e) {
            // a system may refuse while a client reads it: the next time
        }
    }

    @Override
    public void close() throws IOException {
        turn.ifPresent(LogTurn::cancel);
        turn = Optional.empty();
        lock.close();
        channel.close();
    }
}
