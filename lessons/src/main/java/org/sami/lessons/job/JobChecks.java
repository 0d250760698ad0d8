package org.sami.lessons.job;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;

/** Checks the jobs of a course: that they can be read, that their solution passes, that their start does not, that steps which explain are there. */
public final class JobChecks {
    private final Course course;
    private final CourseFiles files;
    private final DomainLibrary domain;
    private final JobGrader grader;
    private final List<Finding> findings = new ArrayList<>();

    private JobChecks(Course course, CourseFiles files, DomainLibrary domain) {
        this.course = course;
        this.files = files;
        this.domain = domain;
        grader = new JobGrader(course, domain);
    }

    /**
     * What is wrong, each with its file; each case is run a few times.
     *
     * @param files where the course was read from
     */
    public static List<Finding> check(Course course, CourseFiles files, DomainLibrary domain) {
        JobChecks checks = new JobChecks(course, files, domain);
        course.jobs().keySet().forEach(checks::check);
        return List.copyOf(checks.findings);
    }

    private void check(String name) {
        int slash = name.indexOf('/');
        String lesson = name.substring(0, slash);
        String path = lesson + "/jobs/" + name.substring(slash + 1) + ".json";
        Reading<Job> read = JobReader.read(files.name(path), course.jobs().getOrDefault(name, ""), domain.vocabulary());
        findings.addAll(read.findings());
        if (read.result().isEmpty()) {
            return;
        }
        Job job = read.result().get();
        Reading<Project> solution = grader.solution(lesson, job);
        if (solution.result().isEmpty()) {
            solution.findings().forEach(finding -> add(path, finding.message()));
            return;
        }
        Verdict right = grader.grade(lesson, job, solution.result().get());
        if (!right.passed()) {
            add(path, "The job's own solution does not pass: " + right.words());
        }
        Optional<Project> start = course.project(lesson, job.start());
        if (start.isEmpty()) {
            add(path, "There is no plan file \"" + job.start() + "\" to start with");
        } else if (grader.grade(lesson, job, start.get()).passed()) {
            add(path, "The plan that the learner starts with passes already");
        }
        Stream.concat(
                        job.uses().stream().flatMap(use -> use.explained().stream()),
                        job.mistakes().stream().flatMap(mistake -> mistake.explained().stream()))
                .distinct()
                .filter(step -> course.address(lesson, step).isEmpty())
                .forEach(step -> add(path, "\"" + step + "\" is no step that could explain a mistake"));
    }

    private void add(String path, String message) {
        findings.add(Finding.error(JobFormat.CODE, "", message).at(new SourceLocation(files.name(path), 1, 1)));
    }
}
