package org.sami.spn.journal;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Set;

/**
 * Files and folders that only their user may read: 0600 and 0700. On a file system without such permissions (Windows) they are what the
 * system makes of them.
 */
public final class PrivateFiles {
    private static final Set<PosixFilePermission> FILE = PosixFilePermissions.fromString("rw-------");
    private static final Set<PosixFilePermission> FOLDER = PosixFilePermissions.fromString("rwx------");

    private PrivateFiles() {}

    /** Makes a folder, and those above it that are not there, all private. One that is there stays as it is: others may use it. */
    public static void makeFolder(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            Files.createDirectories(folder, attributes(folder, FOLDER));
        }
    }

    /** The same for a folder of which this program knows that it is its own: it becomes private if it is there. */
    public static void makeOwnFolder(Path folder) throws IOException {
        makeFolder(folder);
        restrict(folder, FOLDER);
    }

    /** Makes an empty file, unless it is there. */
    static void makeFile(Path file) throws IOException {
        try {
            Files.createFile(file, attributes(file, FILE));
        } catch (FileAlreadyExistsException there) {
            restrict(file, FILE);
        }
    }

    /** Has a file that is there be read by its user only. One that belongs to somebody else stays as it is. */
    static void restrictFile(Path file) {
        if (Files.exists(file)) {
            restrict(file, FILE);
        }
    }

    private static FileAttribute<?>[] attributes(Path path, Set<PosixFilePermission> permissions) {
        return isPosix(path)
                ? new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(permissions)}
                : new FileAttribute<?>[0];
    }

    private static boolean isPosix(Path path) {
        return path.getFileSystem().supportedFileAttributeViews().contains("posix");
    }

    private static void restrict(Path path, Set<PosixFilePermission> permissions) {
        PosixFileAttributeView view = Files.getFileAttributeView(path, PosixFileAttributeView.class);
        if (view == null || (Files.isSymbolicLink(path) && !Files.exists(path, LinkOption.NOFOLLOW_LINKS))) {
            return;
        }
        try {
            if (!permissions.containsAll(view.readAttributes().permissions())) {
                view.setPermissions(permissions);
            }
        } catch (IOException | UnsupportedOperationException others) {
            System.getLogger(PrivateFiles.class.getName())
                    .log(Level.DEBUG, "who may read {0} cannot be set: {1}", path, others.getMessage());
        }
    }
}
