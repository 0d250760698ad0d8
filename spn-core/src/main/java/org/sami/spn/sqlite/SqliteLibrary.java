package org.sami.spn.sqlite;

import java.io.IOException;
import java.io.InputStream;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;
import org.sqlite.SQLiteJDBCLoader;
import org.sqlite.util.LibraryLoaderUtil;
import org.sqlite.util.OSInfo;

/**
 * SQLite's native library, unpacked once into the user's cache folder. The driver itself unpacks it into the temporary folder for each process, and what a
 * killed process unpacked stays there forever, 1 MB each time (docs/session.md).
 */
public final class SqliteLibrary {
    private static final System.Logger LOG = System.getLogger(SqliteLibrary.class.getName());
    private static final String PATH = "org.sqlite.lib.path";
    private static final String NAME = "org.sqlite.lib.name";

    private static boolean chosen;

    private SqliteLibrary() {}

    /**
     * Has the driver take the library from the cache folder. To be called before a process opens its first database; does nothing when it is called again,
     * or where {@code org.sqlite.lib.path} names a library already. Where the folder cannot be written, the driver unpacks the library as it always does.
     */
    public static synchronized void choose() {
        if (chosen) {
            return;
        }
        chosen = true;
        if (System.getProperty(PATH) != null) {
            return;
        }
        try {
            unpacked(cacheOfUser()).ifPresent(file -> {
                System.setProperty(
                        PATH, Objects.requireNonNull(file.getParent(), "folder").toString());
                System.setProperty(NAME, file.getFileName().toString());
            });
        } catch (IOException | SecurityException fault) {
            LOG.log(Level.DEBUG, "SQLite's library cannot be kept in the cache folder", fault);
        }
    }

    /** The cache folder of a person, by the XDG rules. */
    private static Path cacheOfUser() {
        String cache = System.getenv("XDG_CACHE_HOME");
        return cache == null || cache.isBlank()
                ? Path.of(System.getProperty("user.home"), ".cache", "sami")
                : Path.of(cache, "sami");
    }

    /**
     * The library in a cache folder, in a folder of its own for each version, system and processor; unpacked where it is not there, or is another than the
     * driver brings. Several processes may do so at once. Empty where the driver brings none for this machine.
     *
     * @throws IOException if it cannot be written
     */
    static Optional<Path> unpacked(Path cache) throws IOException {
        String name = LibraryLoaderUtil.getNativeLibName();
        byte[] content;
        try (InputStream packed =
                SQLiteJDBCLoader.class.getResourceAsStream(LibraryLoaderUtil.getNativeLibResourcePath() + "/" + name)) {
            if (packed == null) {
                return Optional.empty();
            }
            content = packed.readAllBytes();
        }
        Path folder = cache.toAbsolutePath()
                .resolve("sqlite-" + SQLiteJDBCLoader.getVersion())
                .resolve(OSInfo.getNativeLibFolderPathForCurrentOS().replace('/', '-'));
        Path file = folder.resolve(name);
        if (!isThere(file, content)) {
            Files.createDirectories(folder);
            Path part = Files.createTempFile(folder, name, ".part"); // read and written by its user only
            try {
                Files.write(part, content);
                Files.move(part, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
            } finally {
                Files.deleteIfExists(part);
            }
        }
        return Optional.of(file);
    }

    /** Whether it is whole and nothing else: code is not loaded by its name alone. */
    private static boolean isThere(Path file, byte[] content) throws IOException {
        return Files.isRegularFile(file)
                && Files.size(file) == content.length
                && Arrays.equals(Files.readAllBytes(file), content);
    }
}
