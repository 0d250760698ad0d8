package org.sami.dreamm.start;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.sami.dreamm.profile.Profile;
import org.sami.ui.window.DirectoryLock;

/** Where the program keeps what outlives its windows: settings and the arrangement of panels. Windows of several processes share it. */
public final class AuthorDirectory {
    private final Path folder;

    private AuthorDirectory(Path folder) {
        this.folder = folder;
    }

    /**
     * Opens it; makes it where it is not there.
     *
     * @throws IOException if it cannot be made, saying so in one sentence
     */
    public static AuthorDirectory open(Path folder) throws IOException {
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw new IOException("--data: the folder " + folder + " cannot be made", e);
        }
        return new AuthorDirectory(folder);
    }

    /** The directory of a person who names none. */
    public static Path ofUser() {
        return DirectoryLock.ofUser("dreamm");
    }

    /** The directory itself. */
    public Path folder() {
        return folder;
    }

    /** The file of the arrangement of panels: a profile that hides panels has one of its own. */
    public Path arrangement(Profile profile) {
        String suffix = profile.name().isEmpty()
                ? ""
                : "-" + Integer.toHexString(profile.hide().hashCode());
        return folder.resolve("arrangement" + suffix + ".xml");
    }

    /** The folder in which each window keeps unsaved work. */
    public Path recovery() {
        return folder.resolve("unsaved");
    }

    /** The folder of the learners of this machine. */
    public Path learners() {
        return folder.resolve("learners");
    }

    /** Whether nobody has worked or learned with it yet. */
    public boolean isNew() {
        return !Files.exists(settings()) && !Files.exists(learners());
    }

    /** The file of settings. */
    public Path settings() {
        return folder.resolve("window.properties");
    }
}
