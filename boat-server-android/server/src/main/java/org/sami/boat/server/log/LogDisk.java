package org.sami.boat.server.log;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.Set;

/** The file operations of a boat's log; tests let one fail, or simulate a loss of power after it. */
class LogDisk {
    private static final Set<PosixFilePermission> OWNERS =
            EnumSet.of(PosixFilePermission.OWNER_READ, PosixFilePermission.OWNER_WRITE);

    /** Opens a file to append to it, and makes it where it is missing. */
    FileChannel open(Path file) throws IOException {
        return channel(file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
    }

    /** Makes an empty file, in the place of one that is there. */
    FileChannel create(Path file) throws IOException {
        return channel(file, StandardOpenOption.CREATE, StandardOpenOption.TRUNCATE_EXISTING, StandardOpenOption.WRITE);
    }

    /** The log is read by its user only, where the file system knows users. */
    private static FileChannel channel(Path file, StandardOpenOption... how) throws IOException {
        Set<StandardOpenOption> options = new HashSet<>(Arrays.asList(how));
        PosixFileAttributeView posix = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        if (posix == null) {
            return FileChannel.open(file, options);
        }
        if (Files.isRegularFile(file) && Files.isWritable(file)) {
            try {
                posix.setPermissions(OWNERS);
            } catch (IOException others) {
                // another user's file, whose permissions are not ours to change
            }
        }
        FileAttribute<?> owners = PosixFilePermissions.asFileAttribute(OWNERS);
        return FileChannel.open(file, options, owners);
    }

    /** Appends to a file. */
    void write(FileChannel channel, byte[] content) throws IOException {
        ByteBuffer bytes = ByteBuffer.wrap(content);
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }

    /** Forces what was written to the disk, so that it survives a loss of power. */
    void force(FileChannel channel) throws IOException {
        channel.force(true);
    }

    /** Gives a file its name. */
    void rename(Path from, Path to) throws IOException {
        Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
    }

    /** Forces the names in a folder to the disk, on systems that can. */
    void forceFolder(Path folder) {
        try (FileChannel channel = FileChannel.open(folder, StandardOpenOption.READ)) {
            channel.force(true);
        } catch (IOException e) {
            // not on this system
        }
    }

    /** Removes a file. */
    void delete(Path file) throws IOException {
        Files.deleteIfExists(file);
    }
}
