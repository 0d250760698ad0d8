package org.sami.dreamm.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;

/**
 * The file or folder that a document comes from and is saved to, with what was last seen of it on disk. No window. On the event thread, but
 * where it says otherwise.
 */
public final class ProjectFile {
    private final ProjectDocument document;
    private Optional<DiskVersion> seen = Optional.empty();

    /** The file of a document, as it is on disk now. */
    public ProjectFile(ProjectDocument document) {
        this.document = Objects.requireNonNull(document, "document");
        try {
            if (document.file().isPresent()) {
                seen = Optional.of(DiskVersion.of(document.file().get()));
            }
        } catch (IOException unreadable) {
            seen = Optional.empty(); // it was read a moment ago; the next look says that it changed
        }
    }

    /** A project that was read, with what was on disk then. */
    public record Read(Path path, Project project, DiskVersion version) {}

    /** Where a project is saved again that is opened from a path: the folder, if the path is its {@code project.json}. */
    public static Path home(Path path) throws IOException {
        boolean ofFolder = Files.isRegularFile(path)
                && !DiskVersion.planFiles(path).isEmpty()
                && path.getFileName().toString().equals("project.json");
        Path whole = path.toAbsolutePath();
        return (ofFolder ? whole.resolveSibling("") : whole).normalize();
    }

    /**
     * Reads a project; may be called on any thread.
     *
     * @throws IOException if there is none that can be read, saying why in one sentence
     */
    public Read read(Path path) throws IOException {
        Path home = home(path);
        DiskVersion version = DiskVersion.of(home);
        Reading<Project> reading = new ProjectReader(document.vocabulary()).read(home);
        return new Read(home, reading.result().orElseThrow(() -> new IOException(why(path, reading))), version);
    }

    private static String why(Path path, Reading<Project> reading) {
        long errors = reading.findings().stream().filter(Finding::isError).count();
        String first = reading.findings().stream()
                .filter(Finding::isError)
                .findFirst()
                .map(finding -> place(finding) + finding.message())
                .orElse("it cannot be read");
        return path.getFileName() + " is not opened: " + first
                + (errors > 1 ? ", and " + (errors - 1) + " more; crw check lists them all" : "");
    }

    private static String place(Finding finding) {
        return finding.location().map(at -> "line " + at.line() + ": ").orElse("");
    }

    /** Shows a project that was read instead of the one before. */
    public void open(Read read) {
        seen = Optional.of(read.version());
        document.open(read.project(), Optional.of(read.path()));
    }

    /** Shows a project that has no file yet instead of the one before. */
    public void open(Project project) {
        seen = Optional.empty();
        document.open(project, Optional.empty());
    }

    /** Takes what another program has written as an edit, which can be taken back; it counts as saved. */
    public void take(Read read) {
        document.apply(new ReplaceProject("Load " + read.path().getFileName() + " again", read.project()));
        seen = Optional.of(read.version());
        document.saved(read.path());
    }

    /**
     * Saves the document. A folder gets a file for each plan; the document's own folder loses those of plans that are gone, another one no file.
     *
     * @throws IOException if it cannot be written; what was there before is still there
     */
    public void save(Path path) throws IOException {
        Path home = path.toAbsolutePath().normalize();
        Set<Path> before = Files.isDirectory(home) && isOwn(home) ? DiskVersion.planFiles(home) : Set.of();
        new ProjectWriter(document.vocabulary()).write(document.project(), home);
        if (Files.isDirectory(home)) {
            for (Path file : before) {
                if (!DiskVersion.planFiles(home).contains(file) && file.startsWith(home)) {
                    Files.deleteIfExists(file);
                }
            }
        }
        seen = Optional.of(DiskVersion.of(home));
        document.saved(home);
    }

    /** Whether a path is where the document comes from and is saved to. */
    boolean isOwn(Path path) {
        return document.file()
                .map(own -> own.toAbsolutePath().normalize())
                .filter(path.toAbsolutePath().normalize()::equals)
                .isPresent();
    }

    /** What was last read from the file, or written to it. */
    Optional<DiskVersion> seen() {
        return seen;
    }

    /** What is on disk now, where it is not what was last seen there. */
    Optional<DiskVersion> changedOnDisk() throws IOException {
        if (document.file().isEmpty() || seen.isEmpty()) {
            return Optional.empty();
        }
        return Optional.of(DiskVersion.of(document.file().get())).filter(now -> !now.equals(seen.get()));
    }
}
