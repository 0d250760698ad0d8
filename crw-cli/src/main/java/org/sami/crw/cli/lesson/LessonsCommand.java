package org.sami.crw.cli.lesson;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.output.ErrorMessages;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.UsageFault;
import org.sami.lessons.check.CourseChecks;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.Step;
import org.sami.lessons.job.JobChecks;
import org.sami.lessons.progress.LearnerProgress;
import org.sami.lessons.progress.LearnerTables;
import org.sami.lessons.progress.Learners;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw lessons}: the lessons of the course, their steps and jobs, what learners have done, and what is wrong with a course. */
@Command(
        name = "lessons",
        mixinStandardHelpOptions = true,
        description =
                "Lists the lessons of the course, or the steps of one; with --learners what learners have done; with "
                        + "--check what is wrong with a course of your own.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:done", "1:with --check: something is wrong", "2:wrong usage, or a course that cannot be read"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw lessons",
            "  crw lessons 02-places",
            "  crw lessons 02-places --profile > lesson-2.json",
            "  crw lessons --learners learners --csv",
            "  crw lessons --check --course my-course"
        })
public final class LessonsCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(index = "0", arity = "0..1", paramLabel = "LESSON", description = "The id of a lesson: its steps.")
    private @Nullable String lesson;

    @Mixin
    private CourseOption course = new CourseOption();

    @Option(
            names = "--learners",
            paramLabel = "FOLDER",
            description = "How far each learner of a folder has come: the folder learners of DREAMM's data.")
    private @Nullable Path learners;

    @Option(names = "--csv", description = "With --learners: the tables of a report, as CSV.")
    private boolean csv;

    @Option(
            names = "--check",
            description =
                    "Check texts, pictures, quizzes, show-me's and jobs; each job's solution must pass, its start must not.")
    private boolean check;

    @Option(
            names = "--profile",
            description = "With LESSON: what DREAMM hides and locks in it, as a file for dreamm --profile.")
    private boolean profile;

    @Override
    public Integer call() {
        refuseWhatDoesNotGoTogether();
        Reading<Course> read = course.read();
        if (read.result().isEmpty()) {
            print(read.findings());
            return ExitCode.USAGE;
        }
        Course found = read.result().get();
        if (check) {
            return check(found, read.findings());
        }
        print(read.findings());
        PrintWriter out = spec.commandLine().getOut();
        if (learners != null) {
            learners(out, found, learners);
        } else if (lesson == null) {
            found.lessons().forEach(one -> out.println(line(one)));
        } else if (profile) {
            Lesson one = known(found, lesson);
            out.print(one.mode().profile(one.heading()));
        } else {
            steps(out, known(found, lesson));
        }
        out.flush();
        return ExitCode.OK;
    }

    private void refuseWhatDoesNotGoTogether() {
        if (csv && learners == null) {
            throw new UsageFault("--csv goes with --learners FOLDER");
        }
        if (profile && lesson == null) {
            throw new UsageFault("--profile goes with a LESSON, such as 02-places");
        }
        List<String> asked = new ArrayList<>();
        if (lesson != null) {
            asked.add("LESSON");
        }
        if (learners != null) {
            asked.add("--learners");
        }
        if (check) {
            asked.add("--check");
        }
        if (asked.size() > 1) {
            throw new UsageFault(String.join(" and ", asked) + " do not go together");
        }
    }

    private void print(List<Finding> findings) {
        PrintWriter err = spec.commandLine().getErr();
        FindingsText.print(
                err, "course", findings.stream().filter(Finding::isError).toList());
        err.flush();
    }

    private int check(Course found, List<Finding> ofReading) {
        DomainLibrary domain = PlanSource.library();
        List<Finding> all = new ArrayList<>(ofReading);
        all.addAll(CourseChecks.check(found, course.files(), domain));
        all.addAll(JobChecks.check(found, course.files(), domain));
        PrintWriter out = spec.commandLine().getOut();
        FindingsText.print(out, "course", all);
        out.printf(
                "%s, %s: %s%n",
                count(found.lessons().size(), "lesson", "lessons"),
                count(found.jobs().size(), "job", "jobs"),
                count(all.size(), "finding", "findings"));
        out.flush();
        return all.isEmpty() ? ExitCode.OK : ExitCode.FINDINGS;
    }

    private static String line(Lesson one) {
        long quizzes = one.steps().stream().filter(Step.Quiz.class::isInstance).count();
        long jobs = one.steps().stream().filter(Step.Job.class::isInstance).count();
        return String.format(
                "%-20s %s (%s, %s, %s)",
                one.id(),
                one.heading(),
                count(one.steps().size(), "step", "steps"),
                count(quizzes, "quiz", "quizzes"),
                count(jobs, "job", "jobs"));
    }

    private static String count(long number, String one, String more) {
        return number + " " + (number == 1 ? one : more);
    }

    private static Lesson known(Course found, String id) {
        return found.lesson(id)
                .orElseThrow(() -> new UsageFault("there is no lesson '" + id + "'; the course has "
                        + String.join(
                                ", ", found.lessons().stream().map(Lesson::id).toList())));
    }

    private static void steps(PrintWriter out, Lesson one) {
        out.println(one.heading());
        out.println(one.summary());
        for (Step step : one.steps()) {
            String kind = step.getClass().getSimpleName().toLowerCase(Locale.ROOT);
            String job = step instanceof Step.Job made ? "  crw grade " + one.id() + "/" + made.job() + " FILE" : "";
            out.printf("  %-5s %-24s %s%s%n", kind, step.id(), step.title(), job);
        }
    }

    private void learners(PrintWriter out, Course found, Path folder) {
        if (!Files.isDirectory(folder)) {
            throw new UsageFault("--learners: there is no folder '" + folder + "'");
        }
        Reading<List<LearnerProgress>> read;
        try {
            read = new Learners(folder).all();
        } catch (IOException e) {
            throw new UsageFault("--learners: " + ErrorMessages.words(e));
        }
        print(read.findings());
        List<LearnerProgress> all = read.result().orElse(List.of());
        if (csv) {
            new LearnerTables(found, all).all().forEach(table -> {
                out.println(table.title());
                out.println(table.csv());
            });
            return;
        }
        for (LearnerProgress one : all) {
            long lessons = found.lessons().stream().filter(one::isDone).count();
            int steps = found.lessons().stream().mapToInt(one::done).sum();
            String at = one.resume(found).map(step -> ", goes on at " + step).orElse("");
            out.printf(
                    "%-20s %d of %d lessons, %d of %d steps%s%n",
                    one.learner(),
                    lessons,
                    found.lessons().size(),
                    steps,
                    found.steps().size(),
                    at);
        }
    }
}
