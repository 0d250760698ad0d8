package org.sami.crw.gui.boat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.session.api.FrontFleet;
import org.sami.ui.command.Command;

/** What a person does with the selected boats: commands over the session's fleet. */
final class BoatControl {
    private final OperatorContext context;
    private final List<Command> commands = new ArrayList<>();
    private final Teleoperation teleoperation;

    BoatControl(OperatorContext context) {
        this.context = context;
        teleoperation = new Teleoperation(context);
        add("boat-stop", "Stop", "ctrl shift S", "stop", FrontFleet::stop, "is stopped until it is released");
        add("boat-release", "Release", "ctrl shift R", "release", FrontFleet::release, "goes on");
        if (teleoperation.isOffered()) {
            commands.add(teleoperation.command());
        }
        add("boat-take", "Take command", "ctrl T", "plus", FrontFleet::takeCommand, "is asked to obey this base");
        add(
                "boat-hand-over",
                "Only watch",
                "ctrl shift W",
                "connect",
                FrontFleet::handOver,
                "is watched; another base may command it");
        add(
                "boat-resend",
                "Send path again",
                "ctrl shift U",
                "resend",
                FrontFleet::sendPathAgain,
                "gets its path again");
        add(
                "boat-clear-block",
                "Clear the block",
                "ctrl shift K",
                "clear",
                FrontFleet::clearBlock,
                "is free for other missions");
        add("boat-disconnect", "Disconnect", "ctrl shift X", "link-lost", FrontFleet::disconnect, "is disconnected");
        context.boats().addListener(() -> commands.forEach(Command::refresh));
    }

    Teleoperation teleoperation() {
        return teleoperation;
    }

    /** Ends what is driven by hand. */
    void close() {
        teleoperation.close();
    }

    List<Command> commands() {
        return List.copyOf(commands);
    }

    private <T> void add(
            String id,
            String title,
            String key,
            String icon,
            BiFunction<FrontFleet, String, CompletionStage<T>> action,
            String done) {
        Command command = new Command(
                        id,
                        title,
                        () -> forSelected(boat -> action.apply(context.session().fleet(), boat), done))
                .withKey(key)
                .withIcon(icon)
                .unless(this::whyNot);
        commands.add(context.commands().add(command));
    }

    private <T> void forSelected(Function<String, CompletionStage<T>> action, String done) {
        for (String boat : context.boats().boats()) {
            context.tell(action.apply(boat), boat + " " + done);
        }
    }

    private Optional<String> whyNot() {
        return context.boats().boats().isEmpty() ? Optional.of("select a boat first") : Optional.empty();
    }
}
