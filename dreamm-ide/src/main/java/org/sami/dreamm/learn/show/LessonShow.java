package org.sami.dreamm.learn.show;

import java.util.Objects;
import java.util.Optional;
import javax.swing.JFrame;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.learn.LessonListener;
import org.sami.dreamm.learn.LessonModel;
import org.sami.lessons.course.Step;
import org.sami.lessons.script.EditScript;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.ui.command.Command;

/** Shows the edits of the step at which a learner is, by a command. On the event thread. */
public final class LessonShow implements LessonListener {
    /** The id of the command. */
    public static final String COMMAND = "learn-show";

    private final DreammContext context;
    private final LessonModel model;
    private final JFrame frame;
    private final ShowMe player;

    /** Adds the command and those of the player to a window in which a lesson is taken. */
    public LessonShow(DreammContext context, LessonModel model, JFrame frame) {
        this.context = Objects.requireNonNull(context, "context");
        this.model = Objects.requireNonNull(model, "model");
        this.frame = Objects.requireNonNull(frame, "frame");
        player = new ShowMe(context);
        context.commands()
                .add(new Command(COMMAND, "Show me", this::show)
                        .withKey("alt shift M")
                        .withIcon("play")
                        .unless(() -> model.step() instanceof Step.Show
                                ? Optional.empty()
                                : Optional.of("this step shows nothing")));
        model.addListener(this);
    }

    private void show() {
        if (model.step() instanceof Step.Show show) {
            Optional<Project> project = model.course().project(model.lesson().id(), show.plan());
            Reading<EditScript> script = EditScript.read(show.script(), "/script");
            if (project.isPresent() && script.result().isPresent()) {
                player.start(frame.getRootPane(), project.get(), script.orThrow(), () -> {});
            } else {
                context.notices()
                        .refused("this cannot be shown: "
                                + script.findings().stream()
                                        .findFirst()
                                        .map(Finding::message)
                                        .orElse("there is no plan " + show.plan()));
            }
        }
    }

    @Override
    public void stepChanged() {
        player.stop();
    }

    /** Ends what is shown; the window is closed. */
    public void close() {
        model.removeListener(this);
        player.stop();
    }
}
