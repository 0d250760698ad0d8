package org.sami.lessons.job;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.lessons.course.LessonJson;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * An answer to a job in a file: a plan file, or edits of the solution, the start or another plan of the lesson, as tests of a course write them.
 *
 * @param project the plan
 * @param says part of what the grader is to say of it, where a test says so; else empty text
 */
public record AnswerFile(Project project, String says) {
    private static final String FROM = "from";

    public AnswerFile {
        Objects.requireNonNull(project, "project");
        Objects.requireNonNull(says, "says");
    }

    /**
     * Reads a file.
     *
     * @throws IOException if it cannot be read, or is larger than any answer is
     */
    public static Reading<AnswerFile> read(Path file, String lesson, Job job, JobGrader grader, Vocabulary vocabulary)
            throws IOException {
        return read(file.toString(), BoundedFile.text(file, PlanLimits.MOST_BYTES), lesson, job, grader, vocabulary);
    }

    /** Reads a text. */
    public static Reading<AnswerFile> read(
            String file, String text, String lesson, Job job, JobGrader grader, Vocabulary vocabulary) {
        Reading<JsonNode> tree = LessonJson.read(file, text, JsonNode.class);
        if (tree.result().isEmpty() || !tree.result().get().has(FROM)) {
            Reading<Project> read = new ProjectReader(vocabulary).read(text).locatedIn(file, text);
            return new Reading<>(read.result().map(project -> new AnswerFile(project, "")), read.findings());
        }
        JsonNode edits = tree.result().get();
        String says = edits.path("says").asText();
        List<JsonNode> script = new ArrayList<>();
        edits.path("script").forEach(script::add);
        Reading<Project> made = made(edits.path(FROM).asText(), script, lesson, job, grader);
        return new Reading<>(made.result().map(project -> new AnswerFile(project, says)), made.findings())
                .locatedIn(file, text);
    }

    private static Reading<Project> made(String from, List<JsonNode> script, String lesson, Job job, JobGrader grader) {
        if (!from.equals("solution")) {
            return grader.made(lesson, new Job.Solution(from.equals("start") ? job.start() : from, script));
        }
        List<JsonNode> all = new ArrayList<>(job.solution().script());
        all.addAll(script);
        return grader.made(lesson, new Job.Solution(job.solution().from(), all));
    }

    /** The errors of a reading, each in a line. */
    public static Optional<String> errors(Reading<?> reading) {
        List<String> lines = reading.findings().stream()
                .filter(Finding::isError)
                .map(finding -> finding.location().map(at -> at + ": ").orElse("") + finding.message())
                .toList();
        return lines.isEmpty() ? Optional.empty() : Optional.of(String.join("\n", lines));
    }
}
