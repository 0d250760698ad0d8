package org.sami.lessons.job;

import java.nio.file.Path;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.spn.engine.Engine;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;

/** Prints what is seen of a job's hidden cases with its solution: {@code TraceMain COURSE LESSON JOB}, for who writes a job. */
public final class TraceMain {
    private TraceMain() {}

    /** Prints it. */
    public static void main(String[] args) {
        DomainLibrary domain =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        Course course =
                CourseReader.read(CourseFiles.in(Path.of(args[0])), domain).orThrow();
        Reading<Job> read = JobReader.read(course, args[1], args[2], domain.vocabulary());
        if (read.result().isEmpty()) {
            System.out.println(AnswerFile.errors(read).orElse(""));
            return;
        }
        Job job = read.orThrow();
        JobGrader grader = new JobGrader(course, domain);
        Project project = grader.runnable(grader.solution(args[1], job).orThrow(), grader.ignored(args[1], job));
        Engine engine = new Engine(domain.vocabulary(), project, ScriptedWorld.MOST_FIRINGS);
        for (JobCase one : job.cases()) {
            CaseRun run = ScriptedWorld.run(engine, job.plan(), one, () -> false);
            System.out.println(one.name() + ": " + run.end() + " " + TraceWords.at(run.endMillis()) + " "
                    + run.refusal() + ", questions " + run.questions());
            run.trace().forEach(item -> System.out.println("    " + item));
        }
    }
}
