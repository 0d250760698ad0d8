package org.sami.crw.cli.lesson;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.output.ErrorMessages;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.UsageFault;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.LessonJson;
import org.sami.lessons.job.AnswerFile;
import org.sami.lessons.job.Job;
import org.sami.lessons.job.JobGrader;
import org.sami.lessons.job.JobReader;
import org.sami.lessons.job.Verdict;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw grade}: whether a plan does what a job of the course asks. */
@Command(
        name = "grade",
        mixinStandardHelpOptions = true,
        description =
                "Grades a plan that answers a job of the course, as DREAMM does by Check my plan: by the checks, by "
                        + "what the job asks to be used, and by hidden cases that run on the engine. Prints what is wrong first, "
                        + "and the run that shows it.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:the job is done", "1:it is not", "2:wrong usage, or a file that cannot be read"},
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw grade 02-places/visit-buoy my-plan.json",
            "  crw grade 02-places/visit-buoy my-plan.json --json",
            "  crw grade --course my-course first/begin my-plan.json"
        })
public final class GradeCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(index = "0", paramLabel = "LESSON/JOB", description = "The job, by the id of its lesson and its own.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String name;

    @Parameters(index = "1", paramLabel = "FILE", description = "The plan file.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private Path file;

    @Mixin
    private CourseOption course = new CourseOption();

    @Option(names = "--json", description = "Print one JSON object.")
    private boolean json;

    @Override
    public Integer call() {
        int slash = name.indexOf('/');
        if (slash <= 0 || slash == name.length() - 1) {
            throw new UsageFault("'" + name + "' is no LESSON/JOB, such as 02-places/visit-buoy");
        }
        if (Files.isDirectory(file)) {
            throw new UsageFault("'" + file + "' is a folder; the file of a plan is wanted");
        } else if (!Files.isRegularFile(file)) {
            throw new UsageFault("there is no file '" + file + "'");
        }
        String lesson = name.substring(0, slash);
        Reading<Course> read = course.read();
        Optional<Course> found = read.result();
        if (found.isEmpty() || !found.get().jobs().containsKey(name)) {
            return unreadable(read, found.map(one -> noJob(one)).orElse("the course cannot be read"));
        }
        DomainLibrary domain = PlanSource.library();
        Reading<Job> job = JobReader.read(found.get(), lesson, name.substring(slash + 1), domain.vocabulary());
        if (job.result().isEmpty()) {
            return unreadable(job, "the job " + name + " cannot be read");
        }
        JobGrader grader = new JobGrader(found.get(), domain);
        Reading<AnswerFile> answer = answer(lesson, job.result().get(), grader, domain);
        if (answer.result().isEmpty()) {
            return unreadable(answer, file + " cannot be read as a plan");
        }
        Verdict verdict =
                grader.grade(lesson, job.result().get(), answer.result().get().project());
        print(verdict);
        return verdict.passed() ? ExitCode.OK : ExitCode.FINDINGS;
    }

    private Reading<AnswerFile> answer(String lesson, Job job, JobGrader grader, DomainLibrary domain) {
        try {
            return AnswerFile.read(file, lesson, job, grader, domain.vocabulary());
        } catch (IOException e) {
            throw new UsageFault(ErrorMessages.words(e));
        }
    }

    private String noJob(Course in) {
        return "there is no job '" + name + "'; the course has "
                + String.join(", ", in.jobs().keySet());
    }

    private int unreadable(Reading<?> read, String what) {
        PrintWriter err = spec.commandLine().getErr();
        FindingsText.print(
                err, name, read.findings().stream().filter(Finding::isError).toList());
        err.println("crw: " + what);
        err.flush();
        return ExitCode.USAGE;
    }

    private void print(Verdict verdict) {
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.print(LessonJson.write(verdict));
        } else {
            out.println((verdict.passed() ? "passed: " : "not passed: ") + verdict.words());
            verdict.explained().ifPresent(step -> out.println("explained in " + step));
            verdict.failedCase().ifPresent(one -> {
                out.println("the case \"" + one + "\":");
                verdict.steps().forEach(step -> out.println("  " + step));
            });
        }
        out.flush();
    }
}
