package org.sami.dreamm.learn;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.course.Step;
import org.sami.lessons.job.Job;
import org.sami.lessons.job.JobGrader;
import org.sami.lessons.job.JobReader;
import org.sami.lessons.job.SolutionBeside;
import org.sami.lessons.job.Verdict;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;

/**
 * The job of the step that a learner is at: its plan in the editor, what the grader says of it, and the help that was asked for. Grading runs on a thread of its own
 * and can be cancelled; everything else is called on the owner's thread.
 */
public final class JobModel {
    private static final String PRACTICE = "practice";

    private final LessonModel model;
    private final JobGrader grader;
    private final JobEditor editor;
    private final Executor worker;
    private final Executor owner;
    private Optional<StepAddress> at = Optional.empty();
    private Optional<Job> job = Optional.empty();
    private Optional<String> trouble = Optional.empty();
    private Optional<Verdict> verdict = Optional.empty();
    private Optional<Project> checked = Optional.empty();
    private Optional<AtomicBoolean> cancelling = Optional.empty();
    private int helped;
    private boolean opened;

    /** A step of help, from the least to the most. */
    public enum Help {
        /** A hint. */
        HINT("A hint"),
        /** One that says more. */
        STRONGER("A stronger hint"),
        /** The pattern on another plan. */
        EXAMPLE("A worked example"),
        /** The solution. */
        SOLUTION("The solution");

        private final String title;

        Help(String title) {
            this.title = title;
        }

        /** What people call it. */
        public String title() {
            return title;
        }
    }

    /**
     * The jobs of a window.
     *
     * @param worker grades
     * @param owner is the thread of everything else
     */
    public JobModel(LessonModel model, JobGrader grader, JobEditor editor, Executor worker, Executor owner) {
        this.model = Objects.requireNonNull(model, "model");
        this.grader = Objects.requireNonNull(grader, "grader");
        this.editor = Objects.requireNonNull(editor, "editor");
        this.worker = Objects.requireNonNull(worker, "worker");
        this.owner = Objects.requireNonNull(owner, "owner");
    }

    /** Opens the plan of the step that is shown now; next to a step without a job the plan stays that was open, at first one to practise on. */
    public void showStep() {
        if (at.filter(model.address()::equals).isPresent()) {
            return;
        }
        cancel();
        at = Optional.of(model.address());
        job = Optional.empty();
        trouble = Optional.empty();
        verdict = Optional.empty();
        checked = Optional.empty();
        helped = 0;
        if (model.step() instanceof Step.Job step) {
            read(step);
        } else if (!opened) {
            open(PRACTICE, practice());
        }
    }

    private Project practice() {
        return new Project(
                PRACTICE,
                "Practice: " + model.lesson().title(),
                model.vocabulary().domain(),
                List.of(),
                List.of(),
                List.of(new PlanBuilder(PRACTICE).build()));
    }

    private void read(Step.Job step) {
        Reading<Job> reading = JobReader.read(model.course(), model.lesson().id(), step.job(), model.vocabulary());
        job = reading.result();
        if (job.isEmpty()) {
            trouble = Optional.of("This job cannot be read: "
                    + reading.findings().stream()
                            .findFirst()
                            .map(finding -> finding.message())
                            .orElse("its file is not there"));
            return;
        }
        start().ifPresent(begin -> open(step.job(), begin));
        editor.show(job.get().plan(), Set.of());
    }

    private Optional<Project> start() {
        return job.flatMap(read -> model.course().project(model.lesson().id(), read.start()));
    }

    private void open(String name, Project begin) {
        editor.open(model.record().planOf(model.address(), name), begin);
        opened = true;
    }

    /** The job; empty where the step has none, or one that cannot be read. */
    public Optional<Job> job() {
        return job;
    }

    /** Why the job cannot be done, in a sentence; empty where it can. */
    public Optional<String> trouble() {
        return trouble;
    }

    // ---- Checking

    /** Why the plan cannot be checked now; empty where it can. */
    public Optional<String> whyNotCheck() {
        if (job.isEmpty()) {
            return Optional.of("this step has no job");
        }
        return isChecking() ? Optional.of("it is being checked") : Optional.empty();
    }

    /** Whether the plan is being checked. */
    public boolean isChecking() {
        return cancelling.isPresent();
    }

    /** Begins to check the plan as it is now. */
    public void check() {
        if (whyNotCheck().isPresent()) {
            return;
        }
        Job graded = job.orElseThrow();
        Project project = editor.project();
        String lesson = model.lesson().id();
        AtomicBoolean cancelled = new AtomicBoolean();
        cancelling = Optional.of(cancelled);
        verdict = Optional.empty();
        model.changed();
        worker.execute(() -> {
            Optional<Verdict> said = grade(lesson, graded, project, cancelled);
            owner.execute(() -> finished(cancelled, project, said));
        });
    }

    private Optional<Verdict> grade(String lesson, Job graded, Project project, AtomicBoolean cancelled) {
        try {
            return Optional.of(grader.grade(lesson, graded, project, cancelled::get));
        } catch (CancellationException stopped) {
            return Optional.empty();
        } catch (IllegalStateException unfit) {
            return Optional.of(Verdict.wrong(Verdict.Stage.FILE, String.valueOf(unfit.getMessage()), List.of()));
        }
    }

    private void finished(AtomicBoolean of, Project project, Optional<Verdict> said) {
        if (cancelling.filter(of::equals).isEmpty()) {
            return;
        }
        cancelling = Optional.empty();
        verdict = said;
        checked = Optional.of(project);
        if (said.isPresent()) {
            model.checkedJob(at.orElseThrow(), said.get().passed());
        } else {
            model.changed();
        }
    }

    /** Stops checking. */
    public void cancel() {
        cancelling.ifPresent(flag -> flag.set(true));
        if (cancelling.isPresent()) {
            cancelling = Optional.empty();
            model.changed();
        }
    }

    /** What was said of the plan; empty while it was not checked. */
    public Optional<Verdict> verdict() {
        return verdict;
    }

    /** Whether the plan has been changed since that was said. */
    public boolean isOutdated() {
        return checked.filter(project -> !project.equals(editor.project())).isPresent();
    }

    // ---- After a failure

    /** The run that went wrong; empty where nothing did, or it was not run. */
    public Optional<TestCase> run() {
        return verdict.filter(said -> !said.passed()).flatMap(Verdict::run);
    }

    /** Shows in the editor what the verdict speaks of. */
    public void showElements() {
        verdict.ifPresent(said -> editor.show(job.orElseThrow().plan(), Set.copyOf(said.elements())));
    }

    /**
     * Plays the run that went wrong.
     *
     * @return a run for a picture where the editor cannot play it
     */
    public Optional<PictureRun> play() {
        if (run().isEmpty() || checked.isEmpty()) {
            return Optional.empty();
        }
        String plan = job.orElseThrow().plan();
        if (!isOutdated() && editor.play(plan, run().get())) {
            return Optional.empty();
        }
        Project ran = grader.runnable(model.lesson().id(), job.orElseThrow(), checked.get());
        return ran.plan(plan).map(found -> PictureRun.of(ran, model.vocabulary(), found, run().get()));
    }

    // ---- Help

    /** The help that was asked for so far, in order. */
    public List<Help> help() {
        return ladder().subList(0, Math.min(helped, ladder().size()));
    }

    private List<Help> ladder() {
        List<Help> ladder = new ArrayList<>();
        job.ifPresent(read -> {
            for (int i = 0; i < read.hints().size(); i++) {
                ladder.add(i == 0 ? Help.HINT : Help.STRONGER);
            }
            read.example().ifPresent(example -> ladder.add(Help.EXAMPLE));
            ladder.add(Help.SOLUTION);
        });
        return ladder;
    }

    /** What is shown next on demand; empty where all was shown. */
    public Optional<Help> nextHelp() {
        return helped < ladder().size() ? Optional.of(ladder().get(helped)) : Optional.empty();
    }

    /** Shows it. */
    public void showHelp() {
        Optional<Help> next = nextHelp();
        if (next.isEmpty()) {
            return;
        }
        helped++;
        if (next.get() == Help.SOLUTION) {
            model.record().solved(at.orElseThrow());
            compare();
        } else {
            model.record().hinted(at.orElseThrow());
        }
        model.changed();
    }

    /** Whether the solution was shown, so that the plan can be compared with it. */
    public boolean isSolved() {
        return help().contains(Help.SOLUTION);
    }

    /** Shows the learner's plan and the solution on one net. */
    public void compare() {
        solution()
                .ifPresent(plan -> editor.compareWithSolution(editor.project()
                        .plan(plan.id())
                        .map(mine -> SolutionBeside.of(plan, mine))
                        .orElse(plan)));
    }

    /** The solution's plan; empty where it cannot be made. */
    public Optional<Plan> solution() {
        return job.flatMap(read ->
                grader.solution(model.lesson().id(), read).result().flatMap(project -> project.plan(read.plan())));
    }

    /** The plan of the worked example; empty where there is none. */
    public Optional<Plan> example() {
        return job.flatMap(Job::example)
                .flatMap(example -> model.course().plan(model.lesson().id(), example.plan()));
    }

    /** Begins the job again; that can be taken back. */
    public void startOver() {
        start().ifPresent(begin -> {
            editor.replace("Begin the job anew", begin);
            verdict = Optional.empty();
            model.changed();
        });
    }
}
