package org.sami.dreamm.learn.view;

import java.awt.BorderLayout;
import java.awt.Rectangle;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JScrollPane;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.learn.JobModel;
import org.sami.dreamm.learn.LessonListener;
import org.sami.dreamm.learn.LessonModel;
import org.sami.dreamm.learn.PictureRun;
import org.sami.lessons.course.Step;
import org.sami.palette.SemanticColor;
import org.sami.ui.EventThread;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.command.CommandRow;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.StrongLabel;
import org.sami.ui.sheet.Sheet;
import org.sami.ui.sheet.WindowSheet;

/** The panel of the course: the lesson and how much of it is done, the step, and the way on and back. */
public final class LearnPanel extends JPanel implements LearnActions, LessonListener {
    private final transient LessonModel model;
    private final transient CommandRegistry registry;
    private final transient LearnCommands commands;
    private final StepView step;
    private final JScrollPane scroll;
    private final StrongLabel lesson = new StrongLabel("");
    private final JLabel where = new JLabel();
    private final JProgressBar progress = new JProgressBar();
    private transient Optional<JobModel> jobs = Optional.empty();
    private final CommandButton check;
    private boolean backToCheck;
    private final CommandButton next;

    /** The panel of a window; its commands are added to the registry. */
    public LearnPanel(LessonModel model, CommandRegistry registry) {
        super(new BorderLayout());
        this.model = model;
        this.registry = registry;
        commands = new LearnCommands(registry, model, this);
        check = new CommandButton(commands.check());
        next = new CommandButton(commands.next());
        step = new StepView(model, commands, this::openTerm);
        scroll = step.inPane();
        scroll.setName("learn-scroll");
        setName("learn-panel");
        LookColors.background(this, SemanticColor.SURFACE);
        add(head(), BorderLayout.NORTH);
        add(scroll);
        add(foot(), BorderLayout.SOUTH);
        stepChanged();
        model.addListener(this);
    }

    /** Gives it the jobs of the window, once that has its editor. */
    public void setJobs(JobModel of) {
        jobs = Optional.of(of);
        step.setJobs(of);
        stepChanged();
    }

    @Override
    public Optional<JobModel> jobs() {
        return jobs;
    }

    @Override
    public void playFailure() {
        jobs.flatMap(JobModel::play).ifPresent(failed -> {
            step.play(failed);
            registry.refresh();
            showFeedback();
        });
    }

    /** What gets the keyboard's focus when the panel is shown. */
    public JComponent first() {
        return isToAnswer() ? check : next;
    }

    /** Follows the learner no longer. */
    public void close() {
        model.removeListener(this);
    }

    private JPanel head() {
        JPanel head = new JPanel(new MigLayout("insets 8 16 8 8, gap 4 4, fillx", "[grow, fill, 0:0][][]", "[]2[]4[]"));
        LookColors.background(head, SemanticColor.SURFACE_RAISED);
        lesson.setName("learn-lesson");
        where.setName("learn-where");
        LookColors.foreground(where, SemanticColor.MUTED);
        progress.setName("learn-progress");
        progress.getAccessibleContext().setAccessibleName("Steps of this lesson that are done");
        head.add(lesson, "wmin 0");
        head.add(CommandButton.iconOnly(commands.contents()), "spany 2");
        head.add(CommandButton.iconOnly(commands.glossary()), "spany 2, wrap");
        head.add(where, "wmin 0, wrap");
        head.add(progress, "spanx, growx, hmax 6");
        return head;
    }

    private JPanel foot() {
        CommandRow row = new CommandRow()
                .left(new CommandButton(commands.back()))
                .right(check)
                .right(next);
        row.setName("learn-foot");
        LookColors.background(row, SemanticColor.SURFACE_RAISED);
        LookColors.border(row, () -> BorderFactory.createMatteBorder(Look.px(1), 0, 0, 0, SemanticColor.BORDER.get()));
        return row;
    }

    @Override
    public Optional<PictureRun> run() {
        return step == null ? Optional.empty() : step.run();
    }

    @Override
    public void ran() {
        step.ran();
        registry.refresh();
    }

    @Override
    public void stepChanged() {
        jobs.ifPresent(JobModel::showStep);
        step.showStep();
        showWhere();
        EventThread.later(() -> step.scrollRectToVisible(new Rectangle(0, 0, 1, 1)));
    }

    @Override
    public void changed() {
        boolean pressed = check.isFocusOwner();
        step.refresh();
        showWhere();
        showFeedback();
        if (jobs.filter(JobModel::isChecking).isPresent()) {
            backToCheck |= pressed; // a button that cannot be pressed loses the focus, and the next one has it
        } else if (backToCheck) {
            backToCheck = false;
            first().requestFocusInWindow();
        }
    }

    private void showFeedback() {
        step.feedback()
                .ifPresent(said -> EventThread.later(
                        () -> said.scrollRectToVisible(new Rectangle(0, 0, said.getWidth(), said.getHeight()))));
    }

    private void showWhere() {
        boolean job = model.step() instanceof Step.Job;
        check.setVisible(job || model.quiz().isPresent());
        boolean asks = isToAnswer();
        check.setPrimary(asks, "check");
        next.setPrimary(!asks, "right");
        commands.check().retitle(job ? "Check my plan" : "Check my answer");
        lesson.setText(model.lesson().heading());
        lesson.setToolTipText(model.lesson().summary());
        int all = model.lesson().steps().size();
        int done = model.done(model.lesson());
        where.setText("Step " + (model.index() + 1) + " of " + all + " · " + done + " done");
        progress.setMaximum(all);
        progress.setValue(done);
        commands.next().retitle(model.isLastOfLesson() && model.hasNext() ? "Next lesson" : "Next");
        registry.refresh();
    }

    /** Whether the step asks something that was neither answered nor passed yet: then that is done next. */
    private boolean isToAnswer() {
        return model.step() instanceof Step.Job
                ? !model.isDone(model.address())
                : model.quiz().filter(quiz -> !quiz.isClosed()).isPresent();
    }

    @Override
    public void openContents() {
        open("learn-contents-sheet", "Lessons and steps", new ContentsView(model, this::closeSheet));
    }

    @Override
    public void openGlossary() {
        openTerm("");
    }

    private void openTerm(String term) {
        open("learn-glossary-sheet", "Glossary and search", new GlossaryView(model, term, this::closeSheet));
    }

    private void open(String name, String title, JPanel content) {
        WindowSheet.in(this).open(new Sheet(name, title, content).over(this));
    }

    private void closeSheet() {
        WindowSheet.find(this).ifPresent(WindowSheet::close);
    }
}
