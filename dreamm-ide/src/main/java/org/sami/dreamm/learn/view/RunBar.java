package org.sami.dreamm.learn.view;

import java.util.List;
import java.util.function.IntConsumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.learn.PictureRun;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.value.WrappedText;

/** The buttons below a net that runs: forward, back, to the start; where the learner plays freely, what can happen now. */
final class RunBar extends JPanel {
    private final transient PictureRun run;
    private final transient IntConsumer choose;
    private final JLabel where = new JLabel();
    private final WrappedText message = new WrappedText("");
    private final WrappedText next = WrappedText.strong("");
    private final JPanel choices = new JPanel(new ColumnLayout(Spacing.TIGHT));

    RunBar(PictureRun run, LearnCommands commands, IntConsumer choose) {
        super(new ColumnLayout(Spacing.NORMAL));
        this.run = run;
        this.choose = choose;
        setOpaque(false);
        setName("learn-run");
        JPanel buttons = new JPanel(new MigLayout("insets 0, gap " + Spacing.TIGHT, "[][][]push[]"));
        buttons.setOpaque(false);
        buttons.add(CommandButton.iconOnly(commands.runRestart()));
        buttons.add(CommandButton.iconOnly(commands.runBack()));
        if (run.all().isPresent()) {
            buttons.add(new CommandButton(commands.runForward()));
        }
        where.setName("learn-run-where");
        LookColors.foreground(where, SemanticColor.MUTED);
        buttons.add(where, "cell 3 0");
        message.setName("learn-run-message");
        next.setName("learn-run-next");
        choices.setOpaque(false);
        add(buttons);
        add(message);
        add(next);
        add(choices);
        refresh();
    }

    /** Shows where the run is. */
    void refresh() {
        where.setText(run.all().map(all -> "Step " + run.steps() + " of " + all).orElse("Step " + run.steps()));
        message.setText(run.message() + ".");
        List<String> possible = run.choices();
        boolean free = run.all().isEmpty();
        String nothing = run.isOver() ? "The mission has ended." : "Nothing can happen any more.";
        next.setText(
                free
                        ? possible.isEmpty() ? nothing : "What happens next?"
                        : run.next().map(step -> "Next: " + step).orElse("That was all of it."));
        choices.removeAll();
        for (int i = 0; i < possible.size(); i++) {
            int index = i;
            JButton button = new JButton(possible.get(i));
            button.setName("learn-run-choice-" + (i + 1));
            button.setHorizontalAlignment(JButton.LEADING);
            button.setToolTipText(possible.get(i));
            button.addActionListener(e -> choose.accept(index));
            choices.add(button);
        }
        choices.setVisible(!possible.isEmpty());
        revalidate();
        repaint();
    }
}
