package org.sami.dreamm.learn.show;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandRegistry;

/** The commands with which a learner plays what is shown, each with its key. */
final class ShowCommands {
    private final Supplier<Optional<ShowMeModel>> shown;
    private final Command play;
    private final Command forward;
    private final Command back;
    private final Command speed;
    private final Command stop;

    /**
     * Commands of a window, which are added to its registry.
     *
     * @param shown what is shown now
     * @param end ends it
     */
    ShowCommands(CommandRegistry registry, Supplier<Optional<ShowMeModel>> shown, Runnable end) {
        this.shown = shown;
        play = registry.add(command("show-play", "Play", ShowCommands::playOrPause, model -> true, "")
                .withKey("alt shift P")
                .withIcon("play"));
        forward = registry.add(
                command("show-forward", "Next edit", ShowMeModel::forward, model -> !model.isAtEnd(), "all is shown")
                        .withKey("alt shift RIGHT")
                        .withIcon("right"));
        back = registry.add(command(
                        "show-back",
                        "Back",
                        ShowMeModel::back,
                        model -> model.done() > 0 || model.isMoving(),
                        "nothing was shown yet")
                .withKey("alt shift LEFT")
                .withIcon("left"));
        speed = registry.add(command("show-speed", "Speed", ShowCommands::change, model -> true, "")
                .withKey("alt shift UP")
                .withIcon("clock"));
        stop = registry.add(command("show-stop", "Stop", model -> end.run(), model -> true, "")
                .withKey("alt shift X")
                .withIcon("close"));
    }

    private Command command(
            String id, String title, Consumer<ShowMeModel> run, Predicate<ShowMeModel> can, String otherwise) {
        return new Command(id, title, () -> shown.get().ifPresent(run))
                .unless(() -> shown.get()
                        .map(model -> can.test(model) ? Optional.<String>empty() : Optional.of(otherwise))
                        .orElse(Optional.of("nothing is shown")));
    }

    private static void playOrPause(ShowMeModel model) {
        if (model.isPlaying()) {
            model.pause();
        } else {
            model.play();
        }
    }

    private static void change(ShowMeModel model) {
        model.setSpeed(model.speed().next());
    }

    /** Says on the buttons what they do now. */
    void show(ShowMeModel model) {
        play.retitle(model.isPlaying() ? "Pause" : model.isAtEnd() && model.size() > 0 ? "Play again" : "Play");
        play.withIcon(model.isPlaying() ? "pause" : "play");
        speed.retitle("Speed: " + model.speed().word());
        forward.refresh();
        back.refresh();
        stop.refresh();
    }

    /** Nothing is shown any longer. */
    void ended() {
        play.retitle("Play");
        play.withIcon("play");
        speed.retitle("Speed");
        forward.refresh();
        back.refresh();
        stop.refresh();
    }

    Command play() {
        return play;
    }

    Command forward() {
        return forward;
    }

    Command back() {
        return back;
    }

    Command speed() {
        return speed;
    }

    Command stop() {
        return stop;
    }
}
