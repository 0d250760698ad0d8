package org.sami.dreamm.learn.view;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.learn.JobModel;
import org.sami.dreamm.learn.JobModel.Help;
import org.sami.dreamm.learn.view.FeedbackView.Mood;
import org.sami.lessons.job.Verdict;
import org.sami.spn.model.Plan;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.Spacing;

/** The job of a step: that it is checked, what was wrong, its run, and the help that was asked for. */
final class JobView extends JPanel {
    private final transient JobModel jobs;
    private final transient LearnCommands commands;
    private final transient Function<Plan, JComponent> picture;

    /**
     * A view of the job of a step.
     *
     * @param picture draws a plan
     */
    JobView(JobModel jobs, LearnCommands commands, Function<Plan, JComponent> picture) {
        super(new ColumnLayout(Spacing.INSET));
        this.jobs = jobs;
        this.commands = commands;
        this.picture = picture;
        setOpaque(false);
        setName("learn-job");
        refresh();
    }

    /** Shows what is known of it now. */
    void refresh() {
        removeAll();
        jobs.trouble()
                .ifPresent(why -> add(new FeedbackView(
                        "learn-job-trouble", Mood.WRONG, "This job cannot be done", List.of(why), List.of())));
        if (jobs.isChecking()) {
            checking();
        }
        jobs.verdict().ifPresent(this::said);
        for (int i = 0; i < jobs.help().size(); i++) {
            helped(jobs.help().get(i), i);
        }
        if (jobs.job().isPresent()) {
            JPanel more = new JPanel(new MigLayout("insets 0, gap " + Spacing.TIGHT));
            more.setOpaque(false);
            jobs.nextHelp().ifPresent(next -> {
                commands.hint().retitle(next.title());
                more.add(new CommandButton(commands.hint()));
            });
            more.add(new CommandButton(commands.startOver()));
            add(more);
        }
        revalidate();
        repaint();
    }

    private void checking() {
        JProgressBar bar = new JProgressBar();
        bar.setName("learn-checking");
        bar.setIndeterminate(true);
        bar.getAccessibleContext().setAccessibleName("Your plan is being checked");
        add(bar);
        add(new CommandButton(commands.cancel()));
    }

    private void said(Verdict verdict) {
        List<String> words = new ArrayList<>(List.of(verdict.words()));
        List<JComponent> buttons = new ArrayList<>();
        verdict.failedCase().ifPresent(name -> words.add("It went wrong in the case: " + name + "."));
        if (jobs.isOutdated()) {
            words.add("You have changed the plan since; check it again.");
        }
        if (jobs.run().isPresent()) {
            buttons.add(new CommandButton(commands.failure()));
        }
        if (!verdict.passed() && commands.explanation().isPresent()) {
            buttons.add(new CommandButton(commands.explained()));
        }
        add(new FeedbackView(
                "learn-verdict",
                verdict.passed() ? Mood.RIGHT : Mood.WRONG,
                verdict.passed() ? "Passed" : "Not yet",
                words,
                buttons));
    }

    private void helped(Help help, int index) {
        List<String> words = new ArrayList<>();
        List<JComponent> pictures = new ArrayList<>();
        if (help == Help.EXAMPLE) {
            jobs.job().flatMap(job -> job.example()).ifPresent(example -> words.addAll(example.text()));
            jobs.example().map(picture).ifPresent(pictures::add);
        } else if (help == Help.SOLUTION) {
            words.add("One right plan; others are right as well. Compare it with yours.");
            jobs.solution().map(picture).ifPresent(pictures::add);
            pictures.add(new CommandButton(commands.compare()));
        } else {
            words.addAll(jobs.job().map(job -> job.hints()).orElse(List.of()).subList(index, index + 1));
        }
        add(new FeedbackView("learn-help-" + (index + 1), Mood.NOTE, help.title(), words, pictures));
    }
}
