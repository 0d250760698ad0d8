package org.sami.lessons.progress;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.sami.lessons.course.LessonJson;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;
import org.sami.spn.json.AtomicFile;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.Reading;

/**
 * The learners of a machine: a folder with a folder for each, which holds his progress and the plans of his jobs. Files are replaced whole, so that a
 * program that is killed loses nothing that was kept.
 */
public final class Learners {
    /** What a learner may be called: it becomes the name of a folder. */
    public static final Pattern NAME = Pattern.compile("[\\p{L}\\p{N}][\\p{L}\\p{N} _.-]{0,39}");

    private static final String FILE = "progress.json";

    private final Path folder;

    /** The learners of a folder, which need not be there yet. */
    public Learners(Path folder) {
        this.folder = Objects.requireNonNull(folder, "folder");
    }

    /** The names of all who have begun, in alphabetical order. */
    public List<String> names() throws IOException {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(each -> Files.isRegularFile(each.resolve(FILE)))
                    .map(each -> String.valueOf(each.getFileName()))
                    .sorted()
                    .toList();
        }
    }

    /**
     * What was opened.
     *
     * @param progress what a learner has done
     * @param setAside the file that could not be read and is kept under this name
     * @param why why it could not be read
     */
    public record Opened(LearnerProgress progress, Optional<Path> setAside, String why) {}

    /**
     * Opens the progress of a learner. A file that cannot be understood is set aside under another name, and he begins anew.
     *
     * @throws IOException if a name cannot be that of a learner, or a file can be neither read nor set aside
     */
    public Opened open(String learner) throws IOException {
        Path file = folderOf(learner).resolve(FILE);
        if (!Files.exists(file)) {
            return new Opened(LearnerProgress.of(learner), Optional.empty(), "");
        }
        Reading<LearnerProgress> read = LessonJson.read(
                file.toString(), BoundedFile.text(file, BoundedFile.SETTINGS_BYTES), LearnerProgress.class);
        if (read.result().isPresent()) {
            return new Opened(read.result().get(), Optional.empty(), "");
        }
        Path aside = freeName(file);
        Files.move(file, aside, StandardCopyOption.ATOMIC_MOVE);
        Finding first = read.findings().get(0);
        String line = first.location().map(at -> ", line " + at.line()).orElse("");
        return new Opened(LearnerProgress.of(learner), Optional.of(aside), first.message() + line);
    }

    private static Path freeName(Path file) {
        for (int i = 1; ; i++) {
            Path aside = file.resolveSibling("progress-broken-" + i + ".json");
            if (!Files.exists(aside)) {
                return aside;
            }
        }
    }

    /**
     * Keeps the progress of a learner.
     *
     * @throws IOException if it cannot be written; what was kept before is still there
     */
    public void keep(LearnerProgress progress) throws IOException {
        AtomicFile.write(folderOf(progress.learner()).resolve(FILE), LessonJson.write(progress));
    }

    /**
     * The file in which a learner's plan of a job is kept.
     *
     * @throws IOException if the name cannot be that of a learner
     */
    public Path planOf(String learner, String lesson, String job) throws IOException {
        return folderOf(learner).resolve("jobs").resolve(lesson).resolve(job + ".json");
    }

    private Path folderOf(String learner) throws IOException {
        if (!NAME.matcher(learner).matches()) {
            throw new IOException(
                    "\"" + learner
                            + "\" cannot be the name of a learner: it has 1 to 40 letters, digits, spaces, dots, _ and -, and begins with a letter or digit");
        }
        return folder.resolve(learner);
    }

    /** All who have begun, as far as their files can be read; a finding for each whose file cannot, which is left as it is. */
    public Reading<List<LearnerProgress>> all() throws IOException {
        List<LearnerProgress> all = new ArrayList<>();
        List<Finding> findings = new ArrayList<>();
        for (String name : names()) {
            Path file = folder.resolve(name).resolve(FILE);
            try {
                Reading<LearnerProgress> read = LessonJson.read(
                        file.toString(), BoundedFile.text(file, BoundedFile.SETTINGS_BYTES), LearnerProgress.class);
                read.result().ifPresent(all::add);
                findings.addAll(read.findings());
            } catch (IOException unreadable) {
                findings.add(Finding.error("E-LEARNER", "", "it cannot be read: " + unreadable.getMessage())
                        .at(new SourceLocation(file.toString(), 1, 1)));
            }
        }
        return new Reading<>(Optional.of(all), findings);
    }
}
