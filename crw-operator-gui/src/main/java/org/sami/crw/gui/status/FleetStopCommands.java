package org.sami.crw.gui.status;

import java.awt.event.ActionEvent;
import java.util.Optional;
import javax.swing.Timer;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.ui.command.Command;

/**
 * The fleet stop: one press stops all boats, without a question. The release takes two steps, the second within five seconds of the first.
 */
public final class FleetStopCommands {
    private static final int SECOND_STEP_MS = 5000;

    private final OperatorContext context;
    private final Command stop;
    private final Command release;
    private final Command confirm;
    private final Timer expiry = new Timer(SECOND_STEP_MS, this::expired);
    private boolean pressed;
    private boolean releasing;
    private Runnable changed = () -> {};

    /** Adds the commands to those of the window. */
    public FleetStopCommands(OperatorContext context) {
        this.context = context;
        expiry.setRepeats(false);
        stop = context.commands()
                .add(new Command("fleet-stop", "FLEET STOP", this::stopAll)
                        .withKey("F12")
                        .withIcon("stop")
                        .always());
        release = context.commands()
                .add(new Command("fleet-release", "Release fleet…", this::beginRelease)
                        .withKey("ctrl shift F12")
                        .withIcon("release")
                        .unless(() -> isStopped() ? Optional.empty() : Optional.of("the fleet is not stopped")));
        confirm = context.commands()
                .add(new Command("fleet-release-confirm", "Release: boats go on", this::releaseAll)
                        .withKey("ctrl shift ENTER")
                        .withIcon("release")
                        .unless(() -> releasing
                                ? Optional.empty()
                                : Optional.of("press 'Release fleet' first, then this within five seconds")));
    }

    void onChange(Runnable listener) {
        changed = listener;
    }

    Command stop() {
        return stop;
    }

    Command release() {
        return release;
    }

    Command confirm() {
        return confirm;
    }

    /** Whether the fleet was stopped from here, or a boat says that it is. */
    boolean isStopped() {
        return pressed || context.models().fleetStop().snapshot().isLatched();
    }

    /** Whether that is the state of the whole fleet, and not of single boats. */
    boolean isOfFleet() {
        return pressed || context.models().fleetStop().snapshot().isOfFleet();
    }

    boolean isReleasing() {
        return releasing;
    }

    private void stopAll() {
        pressed = true;
        releasing = false;
        context.tell(context.session().fleet().stopAll(), "Fleet stop: stop sent to every boat");
        refresh();
    }

    private void beginRelease() {
        releasing = true;
        expiry.restart();
        refresh();
    }

    private void expired(ActionEvent e) {
        releasing = false;
        refresh();
    }

    private void releaseAll() {
        pressed = false;
        releasing = false;
        context.tell(
                context.session().fleet().releaseAll(), "The fleet is released; boats go on with what missions want");
        refresh();
    }

    private void refresh() {
        stop.refresh();
        release.refresh();
        confirm.refresh();
        changed.run();
    }
}
