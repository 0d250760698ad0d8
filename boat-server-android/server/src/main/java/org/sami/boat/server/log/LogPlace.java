package org.sami.boat.server.log;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;

/** Path and size limit of a boat's log. Immutable. */
public final class LogPlace {
    private final Path file;
    private final long limitBytes;

    /**
     * A place.
     *
     * @param file the first file of the log, after which later ones are named
     * @param limitBytes most bytes of all files together, at least {@link CommandLogFile#LEAST_BYTES}
     */
    public LogPlace(Path file, long limitBytes) {
        this.file = Objects.requireNonNull(file, "file");
        this.limitBytes = limitBytes;
        if (limitBytes < CommandLogFile.LEAST_BYTES) {
            throw new IllegalArgumentException(
                    "a log has room for " + CommandLogFile.LEAST_BYTES + " bytes or more, not " + limitBytes);
        }
    }

    /** The first file. */
    public Path file() {
        return file;
    }

    /** Most bytes of all files together. */
    public long limitBytes() {
        return limitBytes;
    }

    /**
     * Makes the folder where it is missing.
     *
     * @throws IOException if something else has its name, or it cannot be made
     */
    public void makeFolder() throws IOException {
        Path folder = new LogFiles(file).folder();
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new IOException(folder + " is no folder");
        }
        Files.createDirectories(folder);
    }
}
