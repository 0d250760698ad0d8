package org.sami.lessons.job;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BooleanSupplier;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.LessonMode;
import org.sami.lessons.script.EditScript;
import org.sami.lessons.script.ScriptRun;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.engine.Engine;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.stepping.StepText;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Grades jobs: by the checks of plans, by what a job asks to be used, and by what the plan does in hidden cases, compared with what the
 * solution does. Takes some hundredths of a second, and never more than some seconds whatever the plan; has no thread of its own and may be asked by
 * several.
 */
public final class JobGrader {
    private static final String NO_REQUIREMENT = "E-NO-REQUIREMENT";

    private final Course course;
    private final DomainLibrary domain;
    private final Vocabulary vocabulary;
    private final Map<String, Map<String, CaseRun>> solved = new ConcurrentHashMap<>();

    /** A grader of the jobs of a course. */
    public JobGrader(Course course, DomainLibrary domain) {
        this.course = Objects.requireNonNull(course, "course");
        this.domain = Objects.requireNonNull(domain, "domain");
        vocabulary = domain.vocabulary();
    }

    /** The solution of a job. No project, and a finding, where it cannot be made. */
    public Reading<Project> solution(String lesson, Job job) {
        return made(lesson, job.solution());
    }

    /** A plan file, with the edits that follow. */
    Reading<Project> made(String lesson, Job.Solution solution) {
        Optional<Project> from = course.project(lesson, solution.from());
        if (from.isEmpty() || solution.script().isEmpty()) {
            return from.isPresent()
                    ? new Reading<>(from, List.of())
                    : nothing("There is no plan file \"" + solution.from() + "\"");
        }
        Reading<EditScript> script = EditScript.read(solution.script(), "/solution/script");
        if (script.result().isEmpty()) {
            return new Reading<>(Optional.empty(), script.findings());
        }
        ScriptRun run = script.result().get().applyTo(from.get(), domain);
        return run.refusal().isPresent()
                ? nothing(run.refusal().get().message())
                : new Reading<>(Optional.of(run.project()), List.of());
    }

    private static Reading<Project> nothing(String why) {
        return new Reading<>(
                Optional.empty(), List.of(Finding.error(JobFormat.CODE, "/solution", "The solution: " + why)));
    }

    /** As the other {@code grade}, and never cancelled. */
    public Verdict grade(String lesson, Job job, Project project) {
        return grade(lesson, job, project, () -> false);
    }

    /**
     * Grades a learner's plan.
     *
     * @param lesson id of the lesson that the job is of
     * @param project in which the job's plan stands
     * @param isCancelled asked before each step that is run
     * @throws java.util.concurrent.CancellationException if it is cancelled
     * @throws IllegalStateException if the job's own solution cannot be run, which tests of the course see first
     */
    public Verdict grade(String lesson, Job job, Project project, BooleanSupplier isCancelled) {
        return graded(lesson, job, project, isCancelled).verdict();
    }

    /**
     * A verdict, and what it was found by.
     *
     * @param plan the plan with the cases that were run; empty where the file has none that is run
     */
    record Graded(Verdict verdict, Optional<GradedPlan> plan) {
        private static Graded refused(String why) {
            return new Graded(Verdict.wrong(Verdict.Stage.FILE, why, List.of()), Optional.empty());
        }
    }

    Graded graded(String lesson, Job job, Project project, BooleanSupplier isCancelled) {
        Optional<Plan> plan = project.plan(job.plan());
        if (plan.isEmpty()) {
            return Graded.refused("The file has no plan \"" + job.plan() + "\": that is the plan of this job.");
        }
        Optional<String> excess = PlanLimits.excess(project, job.plan());
        if (excess.isPresent()) {
            return Graded.refused(excess.get());
        }
        LessonMode mode =
                course.lesson(lesson).map(Lesson::mode).orElse(new LessonMode(List.of(), List.of(), List.of()));
        IgnoredFindings ignored = new IgnoredFindings(job, mode);
        List<Finding> findings = PlanChecks.check(project, vocabulary, job.plan());
        List<Finding> errors = ignored.counting(findings);
        Optional<Project> runnable = errors.isEmpty() ? Optional.of(runnable(project, ignored)) : Optional.empty();
        Map<String, CaseRun> right = right(lesson, job, ignored, isCancelled);
        GradedPlan graded =
                new GradedPlan(job, project, plan.get(), runnable, findings, right, vocabulary, isCancelled);
        return new Graded(verdict(lesson, job, project, graded, errors), Optional.of(graded));
    }

    IgnoredFindings ignored(String lesson, Job job) {
        LessonMode none = new LessonMode(List.of(), List.of(), List.of());
        return new IgnoredFindings(job, course.lesson(lesson).map(Lesson::mode).orElse(none));
    }

    /** What is run of a learner's project: where a job asks for none, or the lesson has none yet, with requirements on its edges. */
    public Project runnable(String lesson, Job job, Project project) {
        return runnable(project, ignored(lesson, job));
    }

    /** What is run of a project. */
    Project runnable(Project project, IgnoredFindings ignored) {
        Project computed = ignored.job().isComputed() ? FilledRequirements.computed(project, domain) : project;
        return ignored.isIgnored(NO_REQUIREMENT) ? FilledRequirements.in(computed) : computed;
    }

    private Map<String, CaseRun> right(String lesson, Job job, IgnoredFindings ignored, BooleanSupplier isCancelled) {
        String key = lesson + "/" + job.id() + "/" + job.hashCode();
        Map<String, CaseRun> known = solved.get(key);
        if (known == null) {
            Reading<Project> solution = solution(lesson, job);
            Project right = runnable(
                    solution.result()
                            .orElseThrow(() -> new IllegalStateException(
                                    "The job " + lesson + "/" + job.id() + " has no solution: " + solution.findings())),
                    ignored);
            Engine engine = new Engine(vocabulary, right, ScriptedWorld.MOST_FIRINGS);
            known = new LinkedHashMap<>();
            for (JobCase one : job.cases()) {
                known.put(one.name(), ScriptedWorld.run(engine, job.plan(), one, isCancelled));
            }
            solved.put(key, known);
        }
        return known;
    }

    private Verdict verdict(String lesson, Job job, Project project, GradedPlan graded, List<Finding> errors) {
        Optional<Verdict> wrong = errors.stream()
                .findFirst()
                .map(error -> Verdict.wrong(Verdict.Stage.CHECKS, error.message() + ".", error.elements()))
                .or(() -> uses(lesson, job, graded))
                .or(() -> graded.firstDifferent().map(this::failed));
        if (wrong.isEmpty()) {
            return Verdict.right(praise(job));
        }
        Optional<Job.Mistake> mistake = job.mistakes().stream()
                .filter(one -> one.when().stream().allMatch(predicate -> predicate.holds(graded)))
                .findFirst();
        Verdict said = mistake.map(one -> wrong.get().saying(one.say()).explainedBy(step(lesson, one.explained())))
                .orElse(wrong.get());
        Optional<CaseOutcome> shown = mistake.flatMap(one -> caseNamed(one.when()))
                .flatMap(graded::outcome)
                .filter(outcome -> !outcome.isSame())
                .or(() -> said.stage() == Verdict.Stage.CASES ? graded.firstDifferent() : Optional.empty());
        return shown.map(outcome -> showing(said, outcome, job, project)).orElse(said);
    }

    private static String praise(Job job) {
        int cases = job.cases().size();
        return cases == 0 ? "That is right." : "That is right: it does what it should in all " + cases + " cases.";
    }

    private Optional<Verdict> uses(String lesson, Job job, GradedPlan graded) {
        return job.uses().stream()
                .filter(use -> !use.predicate().holds(graded))
                .findFirst()
                .map(use -> Verdict.wrong(Verdict.Stage.USES, use.otherwise(), List.of())
                        .explainedBy(step(lesson, use.explained())));
    }

    private Verdict failed(CaseOutcome outcome) {
        return Verdict.wrong(Verdict.Stage.CASES, outcome.words(), List.of());
    }

    private static Optional<String> caseNamed(List<JobPredicate> when) {
        return when.stream()
                .filter(JobPredicate.CaseWent.class::isInstance)
                .map(one -> ((JobPredicate.CaseWent) one).name())
                .findFirst();
    }

    private Optional<String> step(String lesson, Optional<String> reference) {
        return reference.map(one ->
                course.address(lesson, one).map(Course.StepAddress::toString).orElse(one));
    }

    private Verdict showing(Verdict said, CaseOutcome outcome, Job job, Project project) {
        TestCase played = outcome.run().played();
        StepText words = StepText.of(project, job.plan(), vocabulary);
        List<String> lines = new ArrayList<>();
        played.steps().forEach(step -> lines.add(words.of(step)));
        return said.showing(outcome.job().name(), lines, played);
    }
}
