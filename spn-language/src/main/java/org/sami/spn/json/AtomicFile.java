package org.sami.spn.json;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.util.Objects;

/** Replaces a file by a new one that is whole and on disk before it takes the name: readers see the old or the new. */
public final class AtomicFile {
    private static final int ATTEMPTS = 1000;

    private AtomicFile() {}

    /**
     * Writes the text; a link is followed, and the permissions of a file that was there are kept.
     *
     * @throws IOException if it cannot be written; the file is as it was
     */
    public static void write(Path path, String text) throws IOException {
        Path file = Files.exists(path) ? path.toRealPath() : path.toAbsolutePath();
        Path folder = Objects.requireNonNull(file.getParent(), "a file lies in a folder");
        Files.createDirectories(folder);
        Path temporary = createSibling(file);
        try {
            try (FileChannel channel = FileChannel.open(temporary, StandardOpenOption.WRITE)) {
                ByteBuffer bytes = ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
                while (bytes.hasRemaining()) {
                    channel.write(bytes);
                }
                channel.force(true);
            }
            copyPermissions(file, temporary);
            Files.move(temporary, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } finally {
            Files.deleteIfExists(temporary);
        }
        syncFolder(folder);
    }

    /** An empty file with the permissions that new files have here; those of the JDK's temporary files are too narrow. */
    private static Path createSibling(Path file) throws IOException {
        for (int i = 0; i < ATTEMPTS; i++) {
            try {
                return Files.createFile(file.resolveSibling("." + file.getFileName() + "." + i + ".tmp"));
            } catch (FileAlreadyExistsException e) {
                // another writer's, or left by one that was killed: take the next
            }
        }
        throw new FileAlreadyExistsException(file + ": too many unfinished copies next to it");
    }

    private static void copyPermissions(Path from, Path to) throws IOException {
        PosixFileAttributeView target = Files.getFileAttributeView(to, PosixFileAttributeView.class);
        if (target != null && Files.exists(from)) {
            target.setPermissions(Files.getPosixFilePermissions(from));
        }
    }

    /** Makes the rename itself durable where the platform lets a folder be opened (Windows does not). */
    private static void syncFolder(Path folder) {
        try (FileChannel channel = FileChannel.open(folder, StandardOpenOption.READ)) {
            channel.force(true);
        } catch (IOException e) {
            // the file is whole either way; only after a power failure might it have its old content
        }
    }
}
