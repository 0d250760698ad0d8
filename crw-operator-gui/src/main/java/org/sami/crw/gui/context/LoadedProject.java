package org.sami.crw.gui.context;

import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/** Knows the file or folder of the project whose plans are started now; empty where it came with the program. On the event thread. */
public final class LoadedProject {
    private Optional<Path> path;

    /** The file with which the session began. */
    public LoadedProject(Optional<Path> path) {
        this.path = Objects.requireNonNull(path, "path");
    }

    /** The file. */
    public Optional<Path> path() {
        return path;
    }

    /** Another project was loaded, or this one has a file now. */
    public void set(Path file) {
        path = Optional.of(file);
    }
}
