package org.sami.lessons.job;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/**
 * Careless authors: of each job's solution mutants are made, and none is accepted that behaves otherwise in a hidden case, be it in output
 * events that the job does not compare. Those that do not differ are accepted, and listed in {@code build/mutants/LESSON-JOB.txt} with the reason, for who wants a case that tells them apart.
 */
@Tag("long")
@Execution(ExecutionMode.CONCURRENT)
class MutantsTest {
    private static final long SEED = 33;
    private static final int MOST_SHIPPED = Integer.getInteger("lessons.mutants", 16); // of a job
    private static final String UNCOMPARED = "differs in what the job does not compare, ";
    private static final DomainLibrary DOMAIN = JobCourse.DOMAIN;
    private static final Course SHIPPED =
            CourseReader.read(CourseFiles.SHIPPED, DOMAIN).orThrow();

    /** One job of a course. */
    record Subject(Course course, String name, int most) {
        String lesson() {
            return name.substring(0, name.indexOf('/'));
        }

        @Override
        public String toString() {
            return name;
        }
    }

    static Stream<Subject> jobs() {
        return Stream.concat(
                JobCourse.COURSE.jobs().keySet().stream()
                        .map(name -> new Subject(JobCourse.COURSE, name, Integer.MAX_VALUE)),
                SHIPPED.jobs().keySet().stream().map(name -> new Subject(SHIPPED, name, MOST_SHIPPED)));
    }

    @ParameterizedTest
    @MethodSource("jobs")
    void noMutantIsAcceptedThatDiffersInAHiddenCase(Subject subject) throws IOException {
        JobGrader grader = new JobGrader(subject.course(), DOMAIN);
        Job job = JobReader.read(
                        subject.course(),
                        subject.lesson(),
                        subject.name().substring(subject.name().indexOf('/') + 1),
                        DOMAIN.vocabulary())
                .orThrow();
        Project solution = grader.solution(subject.lesson(), job).orThrow();
        Plan plan = solution.plan(job.plan()).orElseThrow();
        GradedPlan solved = run(grader, subject, job, solution);
        List<Object> right = seen(job, solved);
        List<String> accepted = new ArrayList<>();
        List<String> wronglyAccepted = new ArrayList<>();
        List<PlanMutants.Mutant> mutants = PlanMutants.of(plan, SEED, subject.most());
        for (PlanMutants.Mutant mutant : mutants) {
            Project mutated = solution.withPlans(solution.plans().stream()
                    .map(one -> one.id().equals(plan.id()) ? mutant.plan() : one)
                    .toList());
            JobGrader.Graded graded = grader.graded(subject.lesson(), job, mutated, () -> false);
            if (graded.verdict().passed()) {
                accepted.add(mutant.error() + ": "
                        + why(
                                job,
                                graded.plan().orElseThrow(),
                                solved,
                                isSameNet(grader, subject, job, mutated, solution)));
                if (!seen(job, graded.plan().orElseThrow()).equals(right)) {
                    wronglyAccepted.add(mutant.error());
                }
            }
        }
        list(subject, mutants.size(), accepted);
        assertThat(wronglyAccepted).as(subject.name()).isEmpty();
        assertThat(accepted).as(subject.name()).noneMatch(one -> one.contains(UNCOMPARED));
        assertThat(accepted.size())
                .as("of %s accepted: %s", mutants.size(), accepted)
                .isLessThan(Math.max(1, mutants.size()));
    }

    private static GradedPlan run(JobGrader grader, Subject subject, Job job, Project project) {
        return grader.graded(subject.lesson(), job, project, () -> false).plan().orElseThrow();
    }

    /** What is seen from outside in all cases, compared without the grader: the watched events as a multiset, and the end. */
    private static List<Object> seen(Job job, GradedPlan plan) {
        List<Object> seen = new ArrayList<>();
        for (JobCase one : job.cases()) {
            CaseRun run = runOf(plan, one);
            Map<TraceItem, Integer> counts = new HashMap<>();
            run.watched(one.watch()).forEach(item -> counts.merge(item, 1, Integer::sum));
            seen.add(counts);
            seen.add(run.end());
            seen.add(run.hasEnded() ? run.endMillis() : 0L);
        }
        return seen;
    }

    private static boolean isSameNet(JobGrader grader, Subject subject, Job job, Project one, Project other) {
        return grader.runnable(subject.lesson(), job, one).equals(grader.runnable(subject.lesson(), job, other));
    }

    /** Why a mutant is accepted. */
    private static String why(Job job, GradedPlan mutant, GradedPlan solved, boolean isSameNet) {
        if (isSameNet) {
            return "the same net runs, for its requirements are computed anew";
        }
        Set<String> unwatched = new TreeSet<>();
        for (JobCase one : job.cases()) {
            List<TraceItem> left = new ArrayList<>(runOf(mutant, one).trace());
            List<TraceItem> more = new ArrayList<>(runOf(solved, one).trace());
            runOf(solved, one).trace().forEach(left::remove);
            runOf(mutant, one).trace().forEach(more::remove);
            Stream.of(left, more).flatMap(List::stream).map(TraceItem::type).forEach(unwatched::add);
        }
        return unwatched.isEmpty()
                ? "in no case is any output event another, or another time; tokens stand elsewhere at most"
                : UNCOMPARED + String.join(", ", unwatched);
    }

    private static CaseRun runOf(GradedPlan plan, JobCase one) {
        return plan.outcome(one.name()).orElseThrow().run();
    }

    private static void list(Subject subject, int all, List<String> accepted) throws IOException {
        Path folder = Files.createDirectories(Path.of("build", "mutants"));
        List<String> lines = new ArrayList<>();
        lines.add(subject.name() + ": " + accepted.size() + " of " + all + " mutants behave as the solution does");
        lines.addAll(accepted);
        Files.write(folder.resolve(subject.name().replace('/', '-') + ".txt"), lines);
    }
}
