package org.sami.crw.report;

import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/**
 * A picture that a boat took.
 *
 * @param atMillis when the boat reported it
 * @param name of its file on board
 * @param latDeg where the boat was, with {@code lonDeg}
 * @param path of its copy in the report's folder, with slashes
 * @param file where it is on this machine; empty where it did not come
 * @param missed why it did not come, in words; empty where it did
 */
public record PictureResult(
        long atMillis,
        String boat,
        long mission,
        String name,
        double latDeg,
        double lonDeg,
        String path,
        Optional<Path> file,
        String missed) {
    public PictureResult {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(path, "path");
        Objects.requireNonNull(file, "file");
        Objects.requireNonNull(missed, "missed");
    }
}
