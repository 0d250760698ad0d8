package org.sami.boat.app.boat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Optional;

/** The app's files in one folder of the phone. What is written is written whole or not at all. */
public final class AppFiles {
    private static final long MOST_BYTES = 65_536;

    private final Path folder;

    /** Files in a folder that is there. */
    public AppFiles(Path folder) {
        this.folder = folder;
    }

    /** Name and port of the boat. */
    Path settings() {
        return folder.resolve("boat.txt");
    }

    /** Settings of the hull. */
    Path hull() {
        return folder.resolve("hull.json");
    }

    /** The boat's commands and answers, which it takes back at each start. */
    Path commandLog() {
        return folder.resolve("commands.log");
    }

    /** Where the boat returns to. */
    Path home() {
        return folder.resolve("home.txt");
    }

    /** Folder of the pictures. */
    Path pictures() {
        return folder.resolve("pictures");
    }

    /** Is there while the boat was stopped on its screen. */
    Path stopped() {
        return folder.resolve("stopped");
    }

    /** Folder of the own key and of those of the bases. */
    Path keys() {
        return folder.resolve("keys");
    }

    /** Is there while whoever reaches the boat commands it. */
    Path openLinks() {
        return folder.resolve("open-links");
    }

    /** The text of a small file; empty if it is missing. */
    static Optional<String> text(Path file) throws IOException {
        if (!Files.exists(file)) {
            return Optional.empty();
        }
        if (Files.size(file) > MOST_BYTES) {
            throw new IOException(file + " is longer than " + MOST_BYTES + " bytes");
        }
        return Optional.of(new String(Files.readAllBytes(file), StandardCharsets.UTF_8));
    }

    /** Replaces a file: whoever reads it finds the old text or the new one. */
    static void write(Path file, String text) throws IOException {
        Path draft = file.resolveSibling(file.getFileName() + ".new");
        Files.write(draft, text.getBytes(StandardCharsets.UTF_8));
        Files.move(draft, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    }
}
