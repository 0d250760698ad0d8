package org.sami.session.record;

import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Objects;
import java.util.UUID;
import org.sami.boat.link.KeptFile;

/**
 * The folder in which a session keeps the pictures of its boats: {@code BOAT/COMMAND/NAME}. Only the user of this process can read it. It is made when the first picture comes. Safe
 * for use by several threads.
 */
public final class SessionPictures implements Closeable {
    private static final String SUFFIX = "-pictures";

    private final Path root;
    private final boolean temporary;

    private SessionPictures(Path root, boolean temporary) {
        this.root = root;
        this.temporary = temporary;
    }

    /** Next to a journal, as {@code JOURNAL-pictures}. */
    public static SessionPictures besides(Path journal) {
        Path name = Objects.requireNonNull(journal.toAbsolutePath().getFileName(), "a journal has a name");
        return in(journal.toAbsolutePath().resolveSibling(name + SUFFIX));
    }

    /** In a folder, which stays. */
    public static SessionPictures in(Path folder) {
        return new SessionPictures(folder.toAbsolutePath(), false);
    }

    /** In a temporary folder, which is deleted when this is closed. */
    public static SessionPictures temporary() {
        Path system = Path.of(System.getProperty("java.io.tmpdir"));
        return new SessionPictures(system.resolve("sami-pictures-" + UUID.randomUUID()), true);
    }

    /**
     * The folder of one panorama, which is there then.
     *
     * @throws IOException if it cannot be made
     */
    public Path folder(String boat, String panorama) throws IOException {
        Path folder =
                Objects.requireNonNull(root.resolve(path(boat, panorama, "x")).getParent(), "folder");
        made(folder);
        return folder;
    }

    private void made(Path folder) throws IOException {
        boolean posix = root.getFileSystem().supportedFileAttributeViews().contains("posix");
        FileAttribute<?>[] own = posix
                ? new FileAttribute<?>[] {
                    PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------"))
                }
                : new FileAttribute<?>[0];
        Files.createDirectories(folder, own);
    }

    /**
     * The place for a file that was noted ({@link #noted}), in a folder that is there then.
     *
     * @throws IOException if the folder cannot be made
     * @throws IllegalArgumentException if it would lie outside
     */
    public Path place(String noted) throws IOException {
        Path file = file(noted);
        made(Objects.requireNonNull(file.getParent(), "folder"));
        return file;
    }

    /** The path of a picture below the folder, with slashes. */
    public static String path(String boat, String panorama, String name) {
        return fileName(boat) + "/" + fileName(panorama) + "/" + name;
    }

    /** Most ids are valid file names; the others are replaced by a UUID that is computed from them. */
    private static String fileName(String id) {
        return KeptFile.isName(id) && id.length() <= 100
                ? id
                : UUID.nameUUIDFromBytes(id.getBytes(StandardCharsets.UTF_8)).toString();
    }

    /** The path of a file as it is written down: relative, so it stays valid when the folder is moved with its journal. */
    public String noted(Path file) {
        return root.relativize(file.toAbsolutePath()).toString().replace('\\', '/');
    }

    /**
     * The file that was noted.
     *
     * @throws IllegalArgumentException if it would lie outside
     */
    public Path file(String noted) {
        Path file = root.resolve(noted).normalize();
        if (!file.startsWith(root) || file.equals(root)) {
            throw new IllegalArgumentException("'" + noted + "' is no picture of this session");
        }
        return file;
    }

    /** Deletes the folder if it is a temporary one. */
    @Override
    public void close() throws IOException {
        if (temporary && Files.isDirectory(root)) {
            delete(root);
        }
    }

    /**
     * Deletes a folder with all that is in it.
     *
     * @throws IOException if something of it cannot be deleted
     */
    public static void delete(Path folder) throws IOException {
        Files.walkFileTree(folder, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
                Files.delete(file);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult postVisitDirectory(Path visited, IOException fault) throws IOException {
                Files.delete(visited);
                return FileVisitResult.CONTINUE;
            }
        });
    }
}
