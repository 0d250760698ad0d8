package org.sami.spn.json;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Files of projects and domains as text. */
final class TextFiles {
    private TextFiles() {}

    static Optional<String> read(Path file) throws IOException {
        return Files.isRegularFile(file)
                ? Optional.of(JsonText.decode(BoundedFile.bytes(file, BoundedFile.PROJECT_BYTES)))
                : Optional.empty();
    }

    /** A file of a folder; a symbolic link may lead to another file of it, and nowhere else. */
    static Optional<String> read(Path folder, String name) throws IOException {
        Path file = folder.resolve(name);
        if (Files.isRegularFile(file) && !file.toRealPath().startsWith(folder.toRealPath())) {
            throw new IOException("a symbolic link leads outside the folder");
        }
        return read(file);
    }
}
