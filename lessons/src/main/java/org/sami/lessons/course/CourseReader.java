package org.sami.lessons.course;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;

/**
 * Reads a course (docs/writing-a-lesson.md). A lesson with a file that cannot be read is left out, with findings that name file, line and element; the
 * others are there.
 */
public final class CourseReader {
    private final RecordFiles files;
    private final ProjectReader projects;
    private final Set<String> asked = new HashSet<>();
    private final Map<String, Project> plans = new LinkedHashMap<>();
    private final Map<String, String> jobs = new LinkedHashMap<>();

    private CourseReader(CourseFiles files, DomainLibrary domain) {
        this.files = new RecordFiles(files);
        projects = new ProjectReader(domain.vocabulary());
    }

    /** The file of a job, as far as the course needs it: which plans it names. */
    private static final List<String> PLANS_OF_JOBS = List.of("start", "solution");

    /**
     * Reads a course.
     *
     * @return what could be read, and all that is wrong; no course only where {@code course.json} cannot be read
     */
    public static Reading<Course> read(CourseFiles files, DomainLibrary domain) {
        return new CourseReader(files, domain).read();
    }

    private Reading<Course> read() {
        Optional<CourseIndex> contents = files.record(CourseIndex.FILE, CourseIndex.class);
        if (contents.isEmpty()) {
            return new Reading<>(Optional.empty(), files.findings());
        }
        List<Lesson> lessons = new ArrayList<>();
        for (String id : contents.get().lessons()) {
            lesson(id).ifPresent(lessons::add);
        }
        List<Term> terms = new ArrayList<>();
        contents.get().terms().forEach(file -> terms.addAll(files.records(file, Term.class)));
        Course course = new Course(lessons, terms, plans, jobs);
        return new Reading<>(Optional.of(course), files.findings());
    }

    private Optional<Lesson> lesson(String id) {
        String file = id + "/lesson.json";
        Optional<Lesson> read = files.record(file, Lesson.class);
        if (read.isEmpty()) {
            return read;
        }
        Lesson lesson = read.get();
        if (lesson.formatVersion() != Lesson.FORMAT_VERSION) {
            files.problem(
                    file,
                    "its \"formatVersion\" is " + lesson.formatVersion() + "; this program reads "
                            + Lesson.FORMAT_VERSION);
            return Optional.empty();
        }
        if (!lesson.id().equals(id)) {
            files.problem(
                    file, "its \"id\" is \"" + lesson.id() + "\"; the name of its folder is wanted, \"" + id + "\"");
            return Optional.empty();
        }
        boolean whole = true;
        for (Step step : lesson.steps()) {
            whole &= parts(lesson, step);
        }
        return whole ? read : Optional.empty();
    }

    private boolean parts(Lesson lesson, Step step) {
        boolean whole =
                step.picture().map(picture -> plan(lesson, picture.plan())).orElse(true);
        if (step instanceof Step.Show show) {
            whole &= plan(lesson, show.plan());
            whole &= show.result().map(result -> plan(lesson, result)).orElse(true);
        } else if (step instanceof Step.Play play) {
            whole &= plan(lesson, play.plan());
        } else if (step instanceof Step.Job job) {
            whole &= job(lesson, job.job());
        }
        return whole;
    }

    private boolean job(Lesson lesson, String name) {
        String file = lesson.id() + "/jobs/" + name + ".json";
        Optional<String> text = files.text(file);
        if (text.isEmpty()) {
            return false;
        }
        Reading<JsonNode> tree = LessonJson.read(files.name(file), text.get(), JsonNode.class);
        files.found(tree.findings());
        if (tree.result().isEmpty()) {
            return false;
        }
        jobs.put(lesson.id() + "/" + name, text.get());
        boolean whole = true;
        for (String member : PLANS_OF_JOBS) {
            JsonNode named = tree.result().get().path(member);
            JsonNode reference = named.isObject() ? named.path("from") : named;
            whole &= !reference.isTextual() || plan(lesson, reference.asText());
        }
        JsonNode example = tree.result().get().path("example").path("plan");
        whole &= !example.isTextual() || plan(lesson, example.asText());
        return whole;
    }

    private boolean plan(Lesson lesson, String reference) {
        String key = Course.fileOf(lesson.id(), reference);
        if (!asked.add(key)) {
            return plans.containsKey(key);
        }
        int slash = key.lastIndexOf('/');
        String file = key.substring(0, slash) + "/plans" + key.substring(slash) + ".json";
        Optional<String> text = files.text(file);
        if (text.isEmpty()) {
            return false;
        }
        Reading<Project> read = projects.read(text.get()).locatedIn(files.name(file), text.get());
        read.findings().stream().filter(Finding::isError).forEach(each -> files.found(List.of(each)));
        read.result().ifPresent(project -> plans.put(key, project));
        return read.result().isPresent();
    }
}
