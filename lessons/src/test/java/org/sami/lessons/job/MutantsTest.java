package org.sami.lessons.job;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/**
 * Careless authors: of each job's solution mutants are made, and none is accepted that behaves otherwise in a hidden case. Those that do not differ
 * are accepted, and listed in {@code build/mutants/LESSON-JOB.txt}, for who wants a case that tells them apart.
 */
class MutantsTest {
    private static final long SEED = 33;
    private static final int MOST_SHIPPED = 40;
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
        List<Object> right = seen(job, run(grader, subject, job, solution));
        List<String> accepted = new ArrayList<>();
        List<String> wronglyAccepted = new ArrayList<>();
        List<PlanMutants.Mutant> mutants = PlanMutants.of(plan, SEED, subject.most());
        for (PlanMutants.Mutant mutant : mutants) {
            Project mutated = solution.withPlans(solution.plans().stream()
                    .map(one -> one.id().equals(plan.id()) ? mutant.plan() : one)
                    .toList());
            JobGrader.Graded graded = grader.graded(subject.lesson(), job, mutated, () -> false);
            if (graded.verdict().passed()) {
                accepted.add(mutant.error());
                if (!seen(job, graded.plan().orElseThrow()).equals(right)) {
                    wronglyAccepted.add(mutant.error());
                }
            }
        }
        list(subject, mutants.size(), accepted);
        assertThat(wronglyAccepted).as(subject.name()).isEmpty();
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
            CaseRun run = plan.outcome(one.name()).orElseThrow().run();
            Map<TraceItem, Integer> counts = new HashMap<>();
            run.watched(one.watch()).forEach(item -> counts.merge(item, 1, Integer::sum));
            seen.add(counts);
            seen.add(run.end());
            seen.add(run.hasEnded() ? run.endMillis() : 0L);
        }
        return seen;
    }

    private static void list(Subject subject, int all, List<String> accepted) throws IOException {
        Path folder = Files.createDirectories(Path.of("build", "mutants"));
        List<String> lines = new ArrayList<>();
        lines.add(subject.name() + ": " + accepted.size() + " of " + all + " mutants behave as the solution does");
        lines.addAll(accepted);
        Files.write(folder.resolve(subject.name().replace('/', '-') + ".txt"), lines);
    }
}
