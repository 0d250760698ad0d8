package org.sami.lessons.check;

import java.util.List;
import java.util.Optional;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.job.Job;
import org.sami.lessons.job.JobGrader;
import org.sami.lessons.job.JobReader;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Project;

/** Finds plans of a job that use what no lesson has introduced yet: its start, its solution and its example. */
final class JobUseCheck {
    private JobUseCheck() {}

    /** Findings with pointers in the file of the job; none where the job cannot be read, which reading it says. */
    static List<Finding> check(Course course, Lesson lesson, String name, DomainLibrary domain) {
        Optional<Job> read =
                JobReader.read(course, lesson.id(), name, domain.vocabulary()).result();
        LessonProblems problems = new LessonProblems();
        read.ifPresent(job -> {
            UseCheck.used(course, lesson, job.start(), "/start", problems);
            Optional<Project> solution =
                    new JobGrader(course, domain).solution(lesson.id(), job).result();
            solution.ifPresent(
                    project -> UseCheck.used(course, lesson, project, "the solution", "/solution", problems));
            job.example()
                    .ifPresent(example -> UseCheck.used(course, lesson, example.plan(), "/example/plan", problems));
        });
        return problems.findings();
    }
}
