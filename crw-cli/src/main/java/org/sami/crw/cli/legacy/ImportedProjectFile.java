package org.sami.crw.cli.legacy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** Where an imported project is written: a file or a folder that was not there before, and appears whole or not at all. */
public final class ImportedProjectFile {
    private final Path path;

    /** A file where the name ends in {@code .json}, else a folder. */
    public ImportedProjectFile(Path path) {
        this.path = Objects.requireNonNull(path, "path");
    }

    /** Why nothing can be written there; empty where something can. */
    public Optional<String> refusal() {
        if (Files.exists(path, java.nio.file.LinkOption.NOFOLLOW_LINKS)) {
            return Optional.of("OUT: " + path + " is there already; an import overwrites nothing");
        }
        Path folder = path.toAbsolutePath().getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            return Optional.of("OUT: there is no folder " + folder);
        }
        return Files.isWritable(folder)
                ? Optional.empty()
                : Optional.of("OUT: nothing can be written to the folder " + folder);
    }

    /** Writes the project and gives it its name at last. */
    public void write(Project project, Vocabulary vocabulary) throws IOException {
        ProjectWriter writer = new ProjectWriter(vocabulary);
        if (String.valueOf(path.getFileName()).endsWith(".json")) {
            writer.write(project, path);
            return;
        }
        Path parent = Objects.requireNonNull(path.toAbsolutePath().getParent());
        Path unfinished = Files.createTempDirectory(parent, ".import-");
        try {
            Path content = Files.createDirectory(unfinished.resolve("project"));
            writer.write(project, content);
            Files.move(content, path.toAbsolutePath(), StandardCopyOption.ATOMIC_MOVE);
        } finally {
            delete(unfinished);
        }
    }

    private static void delete(Path folder) throws IOException {
        List<Path> all;
        try (Stream<Path> walk = Files.walk(folder)) {
            all = walk.sorted(Comparator.reverseOrder()).toList();
        }
        for (Path each : all) {
            Files.delete(each);
        }
    }
}
