package org.sami.spn.testing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.stream.Stream;

/** A new folder for a program that is run by the build and is no test: it is deleted with all that is in it. */
public final class TemporaryFolder implements AutoCloseable {
    private final Path path;

    /**
     * Makes one among the system's temporary files.
     *
     * @param prefix of its name
     */
    public TemporaryFolder(String prefix) throws IOException {
        path = Files.createTempDirectory(prefix);
    }

    /** Where it is. */
    public Path path() {
        return path;
    }

    /** Deletes it; nobody may write into it any more. */
    @Override
    public void close() throws IOException {
        try (Stream<Path> files = Files.walk(path)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }
}
