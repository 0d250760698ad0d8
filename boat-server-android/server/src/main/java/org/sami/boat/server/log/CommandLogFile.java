package org.sami.boat.server.log;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.EnumSet;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.server.ServerLog;
import org.sami.boat.server.file.BoatFiles;

/**
 * A boat's log as a text file with one line for each command, appended to over all starts. The operating system gets each line before the boat's answer
 * leaves, so that the death of the process loses no answered command; a line that was cut off is removed at the next opening. A loss of power can lose
 * the last seconds.
 *
 * <p>A file that cannot be written does not stop the boat: it reports the fault once and goes on without a log. For the thread that drives the boat.
 */
public final class CommandLogFile implements ServerLog, Closeable {
    private static final Set<PosixFilePermission> OWNERS =
            EnumSet.of(PosixFilePermission.OWNER_READ, PosixFilePermission.OWNER_WRITE);
    private static final Set<StandardOpenOption> OPTIONS =
            EnumSet.of(StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);

    private final FileChannel channel;
    private final String bootId;
    private final int unreadLines;
    private final EpochFile epochFile;
    private final CommandEpoch epoch;
    private final Consumer<IOException> onFault;
    private boolean broken;

    private CommandLogFile(
            FileChannel channel, String bootId, int unreadLines, EpochFile epochFile, Consumer<IOException> onFault)
            throws IOException {
        this.channel = channel;
        this.bootId = bootId;
        this.unreadLines = unreadLines;
        this.epochFile = epochFile;
        epoch = epochFile.read();
        this.onFault = onFault;
    }

    /**
     * Opens or creates a boat's log, reads its entries and adds the start of this server.
     *
     * @param bootId names this start
     * @param earlier receives every entry of the earlier starts, in order
     * @param onFault receives the fault when the log can no longer be written
     * @throws IOException if the file cannot be read or written, is no boat's log, or another process writes it
     */
    public static CommandLogFile open(
            Path file, String bootId, Consumer<LoggedCommand> earlier, Consumer<IOException> onFault)
            throws IOException {
        FileChannel channel = FileChannel.open(file, OPTIONS, ownersOnly(file));
        try {
            lock(channel, file);
            LogExtent extent = LogLines.read(file, earlier);
            channel.truncate(extent.wholeBytes());
            channel.position(extent.wholeBytes());
            CommandLogFile log = new CommandLogFile(
                    channel,
                    bootId,
                    extent.unreadLines(),
                    new EpochFile(file),
                    Objects.requireNonNull(onFault, "onFault"));
            log.write(LogLines.start(bootId));
            return log;
        } catch (IOException | RuntimeException e) {
            channel.close();
            throw e;
        }
    }

    /** The log as clients may fetch it; nothing else of its folder, where other boats of this machine may have theirs. */
    public static BoatFiles files(Path file) {
        String name = String.valueOf(file.getFileName());
        Path folder = Objects.requireNonNull(file.toAbsolutePath().getParent(), "a log stands in a folder");
        return BoatFiles.none().with(KeptFile.LOG, folder, name::equals);
    }

    /** The log is read by its user only, where the file system knows users. */
    private static FileAttribute<?>[] ownersOnly(Path file) throws IOException {
        PosixFileAttributeView posix = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        if (posix == null) {
            return new FileAttribute<?>[0];
        }
        if (Files.isRegularFile(file) && Files.isWritable(file)) {
            try {
                posix.setPermissions(OWNERS);
            } catch (IOException others) {
                // another user's file, whose permissions are not ours to change
            }
        }
        return new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(OWNERS)};
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

    /** How many lines of the earlier starts said nothing, because they are damaged. */
    public int unreadLines() {
        return unreadLines;
    }

    @Override
    public void answered(long nowMs, String clientId, CommandMessage command, LinkMessage answer) {
        add(LogLines.command(new LoggedCommand(bootId, nowMs, clientId, command, answer)));
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
            onFault.accept(e);
        }
    }

    @Override
    public void leftOut(long nowMs, long count) {
        add(LogLines.leftOut(bootId, nowMs, count));
    }

    private void add(String line) {
        if (broken) {
            return;
        }
        try {
            write(line);
        } catch (IOException e) {
            broken = true;
            onFault.accept(e);
        }
    }

    private void write(String line) throws IOException {
        ByteBuffer bytes = ByteBuffer.wrap(line.getBytes(StandardCharsets.UTF_8));
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
