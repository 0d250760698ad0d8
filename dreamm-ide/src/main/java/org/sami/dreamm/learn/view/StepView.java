package org.sami.dreamm.learn.view;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import org.sami.dreamm.learn.JobModel;
import org.sami.dreamm.learn.LessonModel;
import org.sami.dreamm.learn.PictureRun;
import org.sami.dreamm.learn.QuizModel;
import org.sami.dreamm.learn.StepRuns;
import org.sami.dreamm.learn.TokenDraft;
import org.sami.dreamm.learn.view.FeedbackView.Mood;
import org.sami.lessons.course.Grade;
import org.sami.lessons.course.Paragraph;
import org.sami.lessons.course.Picture;
import org.sami.lessons.course.QuizQuestion;
import org.sami.lessons.course.Step;
import org.sami.lessons.course.Term;
import org.sami.palette.ProxyMarks;
import org.sami.palette.SemanticColor;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.ScrolledPanel;
import org.sami.ui.look.Spacing;
import org.sami.ui.table.TooltipLines;
import org.sami.ui.value.WrappedText;

/** One step as it is read: title, paragraphs, picture, what is asked, and what is said of the answer. */
final class StepView extends ScrolledPanel {
    private static final int WIDEST = 760;

    private final transient LessonModel model;
    private final transient LearnCommands commands;
    private final transient Consumer<String> openTerm;
    private final transient ProxyMarks marks = new ProxyMarks();
    private transient Optional<PictureRun> run = Optional.empty();
    private transient Optional<PictureView> picture = Optional.empty();
    private transient Optional<QuizView> quiz = Optional.empty();
    private transient Optional<RunBar> runBar = Optional.empty();
    private transient Optional<JobView> jobView = Optional.empty();
    private transient Optional<JComponent> feedback = Optional.empty();
    private transient Optional<JobModel> jobs = Optional.empty();
    private transient Optional<PicturePane> failedPicture = Optional.empty();
    private transient Optional<String> whyNoRun = Optional.empty();

    /**
     * A view of the step that a learner is at.
     *
     * @param openTerm is given a term of the glossary that was chosen
     */
    StepView(LessonModel model, LearnCommands commands, Consumer<String> openTerm) {
        super(new ColumnLayout(Spacing.INSET, WIDEST));
        this.model = model;
        this.commands = commands;
        this.openTerm = openTerm;
        setName("learn-step");
        LookColors.border(
                this,
                () -> BorderFactory.createEmptyBorder(
                        Look.px(Spacing.INSET), Look.px(Spacing.WIDE), Look.px(Spacing.WIDE), Look.px(Spacing.WIDE)));
        List.of("anna", "bert", "carl", "dora", "emil").forEach(marks::give);
    }

    /** The run in the picture; empty where nothing runs yet. */
    Optional<PictureRun> run() {
        return run;
    }

    /** Shows the step at which the learner is now, from its beginning. */
    void showStep() {
        removeAll();
        run = Optional.empty();
        runBar = Optional.empty();
        feedback = Optional.empty();
        whyNoRun = Optional.empty();
        Step step = model.step();
        if (step instanceof Step.Quiz asked && asked.review()) {
            addNote("learn-review", "Review: what this lesson builds on");
        }
        WrappedText title = WrappedText.heading(step.title());
        title.setName("learn-step-title");
        add(title);
        for (String paragraph : step.text()) {
            TermText text = new TermText(Paragraph.of(paragraph), this::meaning, openTerm);
            text.setName("learn-paragraph");
            add(text);
        }
        Optional<QuizView.Drawn> drawn = isInEditor(step) ? Optional.empty() : drawn(step);
        picture = drawn.map(QuizView.Drawn::view);
        drawn.ifPresent(there -> add(new PicturePane(there.view())));
        step.picture()
                .map(Picture::caption)
                .filter(caption -> !caption.isEmpty() && picture.isPresent())
                .ifPresent(caption -> addNote("learn-caption", caption));
        quiz = model.quiz().map(asked -> new QuizView(asked, drawn, marks, model::changed));
        quiz.ifPresent(this::add);
        jobView = step instanceof Step.Job
                ? jobs.map(of -> new JobView(of, commands, this::pictureOf))
                : Optional.empty();
        jobView.ifPresent(this::add);
        if (step instanceof Step.Play) {
            begin();
        }
        if (step instanceof Step.Show) {
            commands.show().ifPresent(show -> add(CommandButton.primary(show, "play")));
        }
        refresh();
    }

    /** Shows the jobs of a window from now on. */
    void setJobs(JobModel of) {
        jobs = Optional.of(of);
    }

    private JComponent pictureOf(Plan plan) {
        return new PicturePane(new PictureView(plan, model.vocabulary(), marks));
    }

    /** Plays a run of the learner's plan below what was said of it. */
    void play(PictureRun failed) {
        runBar.ifPresent(this::remove);
        failedPicture.ifPresent(this::remove);
        PictureView view = new PictureView(failed.plan(), model.vocabulary(), marks);
        picture = Optional.of(view);
        PicturePane pane = new PicturePane(view);
        failedPicture = Optional.of(pane);
        add(pane);
        run = Optional.of(failed);
        addRun(failed);
        feedback = Optional.of(pane);
        revalidate();
    }

    private void addNote(String name, String words) {
        WrappedText note = new WrappedText(words);
        note.setName(name);
        note.setColor(SemanticColor.MUTED);
        add(note);
    }

    private Optional<String> meaning(String term) {
        return model.course().term(term).map(Term::text).map(TooltipLines::of);
    }

    private Optional<QuizView.Drawn> drawn(Step step) {
        Optional<Plan> plan = StepRuns.plan(step)
                .flatMap(reference -> model.course().plan(model.lesson().id(), reference));
        return plan.map(found -> {
            PictureView view = new PictureView(found, model.vocabulary(), marks);
            step.picture().ifPresent(said -> {
                view.setPointedOut(new LinkedHashSet<>(said.mark()));
                view.setMarking(TokenDraft.marking(said.tokens()));
            });
            return new QuizView.Drawn(view, found);
        });
    }

    /** Whether the picture of a step is the plan that its job begins with, which the editor shows. */
    private boolean isInEditor(Step step) {
        String lesson = model.lesson().id();
        Optional<Project> begun = jobs.flatMap(JobModel::job)
                .filter(job -> step instanceof Step.Job)
                .flatMap(job -> model.course().project(lesson, job.start()));
        return begun.isPresent()
                && begun.equals(step.picture().flatMap(drawn -> model.course().project(lesson, drawn.plan())));
    }

    private void begin() {
        try {
            run = StepRuns.of(model.course(), model.vocabulary(), model.lesson(), model.step());
        } catch (IllegalArgumentException refused) {
            whyNoRun = Optional.of(String.valueOf(refused.getMessage()));
        }
        run.ifPresent(this::addRun);
    }

    /** Has the picture show a run. */
    private void addRun(PictureRun running) {
        RunBar bar = new RunBar(running, commands, index -> {
            running.choose(index);
            ran();
        });
        runBar = Optional.of(bar);
        add(bar);
        ran();
    }

    /** Shows where the run is. */
    void ran() {
        run.ifPresent(running -> picture.ifPresent(view -> {
            view.setMarking(running.marking());
            view.setFiring(running.fired());
        }));
        runBar.ifPresent(RunBar::refresh);
    }

    /** Shows what is said of the answer. */
    void refresh() {
        if (model.step() instanceof Step.Job) {
            jobView.ifPresent(JobView::refresh);
            feedback = jobView.map(JComponent.class::cast);
            return;
        }
        feedback.ifPresent(this::remove);
        feedback = model.quiz().flatMap(this::said);
        feedback.ifPresent(said -> add(said, runBar.isPresent() ? getComponentCount() - 1 : getComponentCount()));
        quiz.ifPresent(QuizView::refresh);
        if (run.isEmpty() && model.quiz().filter(QuizModel::isClosed).isPresent()) {
            picture.ifPresent(view -> view.setPointedOut(java.util.Set.of()));
            beginAnswer();
        }
        whyNoRun.ifPresent(why -> {
            addNote("learn-no-run", "It cannot be played: " + why);
            whyNoRun = Optional.empty();
        });
        revalidate();
        repaint();
    }

    /** Plays what is right, from its beginning, where the quiz has a run for it. */
    private void beginAnswer() {
        begin();
        run.ifPresent(running -> {
            if (model.step() instanceof Step.Quiz asked && asked.ask() instanceof QuizQuestion.Tokens tokens) {
                for (int i = 0; i < tokens.steps(); i++) {
                    running.forward();
                }
            }
            ran();
        });
    }

    private Optional<JComponent> said(QuizModel asked) {
        if (asked.isWrong()) {
            return Optional.of(wrong(asked.grade().orElseThrow()));
        }
        return asked.grade()
                .filter(Grade::right)
                .map(grade -> new FeedbackView(
                        "learn-feedback",
                        asked.isRevealed() ? Mood.NOTE : Mood.RIGHT,
                        asked.isRevealed() ? "The right answer" : "Right",
                        grade.words(),
                        List.of()));
    }

    private JComponent wrong(Grade grade) {
        List<JComponent> buttons = new ArrayList<>();
        String where = model.step() instanceof Step.Quiz asked
                ? model.course()
                        .address(model.lesson().id(), asked.explained())
                        .flatMap(address ->
                                model.course().lesson(address.lesson()).flatMap(lesson -> lesson.step(address.step())))
                        .map(Step::title)
                        .orElse("")
                : "";
        CommandButton explained = new CommandButton(commands.explained());
        if (!where.isEmpty()) {
            explained.setText("Explained in: " + where);
        }
        buttons.add(explained);
        buttons.add(new CommandButton(commands.reveal()));
        List<String> words = new ArrayList<>(grade.words());
        words.add("Change your answer and check it again, or look at the right one.");
        return new FeedbackView("learn-feedback", Mood.WRONG, "Not right", words, buttons);
    }

    /** What is read last: where something new is said, it is brought into sight. */
    Optional<JComponent> feedback() {
        return feedback;
    }
}
