package org.sami.dreamm.learn.view;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.sami.dreamm.learn.JobModel;
import org.sami.dreamm.learn.LessonModel;
import org.sami.dreamm.learn.PictureRun;
import org.sami.dreamm.learn.QuizModel;
import org.sami.dreamm.learn.show.LessonShow;
import org.sami.lessons.course.Step;
import org.sami.lessons.job.Verdict;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandRegistry;

/** The commands of a learner's way through a lesson, each with its key. */
final class LearnCommands {
    private final LessonModel model;
    private final LearnActions actions;
    private final Command next;
    private final Command back;
    private final Command check;
    private final Command reveal;
    private final Command explained;
    private final Command cancel;
    private final Command hint;
    private final Command failure;
    private final Command startOver;
    private final Command compare;
    private final Command contents;
    private final Command glossary;
    private final Command runForward;
    private final Command runBack;
    private final Command runRestart;
    private final Optional<Command> show;

    LearnCommands(CommandRegistry registry, LessonModel model, LearnActions actions) {
        this.model = model;
        this.actions = actions;
        show = registry.find(LessonShow.COMMAND);
        next = registry.add(new Command("learn-next", "Next", model::forward)
                .withKey("alt PAGE_DOWN")
                .withIcon("right")
                .unless(() -> model.hasNext() ? Optional.empty() : Optional.of("this is the end of the course")));
        back = registry.add(new Command("learn-back", "Back", model::back)
                .withKey("alt PAGE_UP")
                .withIcon("left")
                .unless(() -> model.hasBack() ? Optional.empty() : Optional.of("this is the first step")));
        check = registry.add(new Command("learn-check", "Check my answer", this::checkNow)
                .withKey("F4")
                .withIcon("check")
                .unless(this::whyNotCheck));
        cancel = registry.add(new Command(
                        "learn-cancel", "Stop checking", () -> actions.jobs().ifPresent(JobModel::cancel))
                .withKey("alt shift F4")
                .withIcon("stop")
                .unless(() -> of(JobModel::isChecking, "nothing is being checked")));
        hint = registry.add(
                new Command("learn-hint", "A hint", () -> actions.jobs().ifPresent(JobModel::showHelp))
                        .withKey("F3")
                        .withIcon("help")
                        .unless(() -> of(jobs -> jobs.nextHelp().isPresent(), "there is no more help")));
        failure = registry.add(new Command("learn-failure", "Play what went wrong", actions::playFailure)
                .withKey("ctrl F4")
                .withIcon("play")
                .unless(() -> of(jobs -> jobs.run().isPresent(), "no run went wrong")));
        startOver = registry.add(new Command(
                        "learn-start-over",
                        "Begin the job anew",
                        () -> actions.jobs().ifPresent(JobModel::startOver))
                .withKey("ctrl shift F4")
                .withIcon("undo")
                .unless(() -> of(jobs -> jobs.job().isPresent(), "this step has no job")));
        compare = registry.add(new Command(
                        "learn-compare",
                        "Compare with the solution",
                        () -> actions.jobs().ifPresent(JobModel::compare))
                .withKey("ctrl F3")
                .withIcon("compare")
                .unless(() -> of(JobModel::isSolved, "ask for all help first: the solution comes last")));
        reveal = registry.add(new Command("learn-reveal", "Show the right answer", model::reveal)
                .withKey("shift F4")
                .withIcon("help")
                .unless(() -> model.quiz().filter(QuizModel::isWrong).isPresent()
                        ? Optional.empty()
                        : Optional.of("answer first")));
        explained = registry.add(new Command("learn-explained", "Go to where it was explained", this::goToExplained)
                .withKey("alt shift E")
                .withIcon("go-to")
                .unless(() -> explanation().isPresent() ? Optional.empty() : Optional.of("nothing was wrong")));
        contents = registry.add(new Command("learn-contents", "Lessons and steps", actions::openContents)
                .withKey("alt shift T")
                .withIcon("layers"));
        glossary = registry.add(new Command("learn-glossary", "Glossary and search", actions::openGlossary)
                .withKey("alt shift W")
                .withIcon("search"));
        runForward = registry.add(new Command("learn-run-forward", "Step on", () -> move(PictureRun::forward))
                .withKey("alt RIGHT")
                .withIcon("play")
                .unless(() -> actions.run().filter(PictureRun::hasNext).isPresent()
                        ? Optional.empty()
                        : Optional.of("no step is left")));
        runBack = registry.add(new Command("learn-run-back", "Step back", () -> move(PictureRun::back))
                .withKey("alt LEFT")
                .withIcon("undo")
                .unless(this::whyNotBack));
        runRestart = registry.add(new Command("learn-run-restart", "To the start", () -> move(PictureRun::restart))
                .withKey("alt shift HOME")
                .withIcon("home")
                .unless(this::whyNotBack));
    }

    private Optional<String> of(Predicate<JobModel> so, String otherwise) {
        return actions.jobs().filter(so).isPresent() ? Optional.empty() : Optional.of(otherwise);
    }

    private Optional<String> whyNotCheck() {
        if (model.step() instanceof Step.Job) {
            return actions.jobs().map(JobModel::whyNotCheck).orElse(Optional.of("no plan is open yet"));
        }
        return model.quiz().isEmpty()
                ? Optional.of("this step asks nothing")
                : model.quiz().flatMap(QuizModel::whyNotCheck);
    }

    private void checkNow() {
        if (model.step() instanceof Step.Job) {
            actions.jobs().ifPresent(JobModel::check);
        } else {
            model.check();
        }
    }

    private Optional<String> whyNotBack() {
        return actions.run().filter(run -> run.steps() > 0).isPresent()
                ? Optional.empty()
                : Optional.of("no step was taken");
    }

    private void move(Consumer<PictureRun> how) {
        actions.run().ifPresent(how);
        actions.ran();
    }

    private void goToExplained() {
        explanation()
                .flatMap(step -> model.course().address(model.lesson().id(), step))
                .ifPresent(model::go);
    }

    /** The step that explains what was wrong. */
    Optional<String> explanation() {
        return model.step() instanceof Step.Quiz quiz
                ? Optional.of(quiz.explained())
                : actions.jobs().flatMap(JobModel::verdict).flatMap(Verdict::explained);
    }

    Command next() {
        return next;
    }

    Command back() {
        return back;
    }

    Command check() {
        return check;
    }

    Command reveal() {
        return reveal;
    }

    Command explained() {
        return explained;
    }

    Command cancel() {
        return cancel;
    }

    Command hint() {
        return hint;
    }

    Command failure() {
        return failure;
    }

    Command startOver() {
        return startOver;
    }

    Command compare() {
        return compare;
    }

    Command contents() {
        return contents;
    }

    Command glossary() {
        return glossary;
    }

    Command runForward() {
        return runForward;
    }

    Command runBack() {
        return runBack;
    }

    Command runRestart() {
        return runRestart;
    }

    /** Plays what a step shows; empty in a window without an editor. */
    Optional<Command> show() {
        return show;
    }
}
