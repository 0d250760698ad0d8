package org.sami.crw.gui.status;

import java.awt.event.ActionEvent;
import java.util.Optional;
import javax.swing.Timer;
import org.jspecify.annotations.Nullable;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.FleetStopState;
import org.sami.session.api.RefusedException;
import org.sami.ui.command.Command;

/**
 * The fleet stop: one press stops all boats, without a question. Whether the fleet is stopped is what the session says, not that somebody pressed; a stop that could not be sent
 * is said until one is sent. The release takes two steps, the second within five seconds of the first. On the event thread.
 */
public final class FleetStopCommands {
    private static final int SECOND_STEP_MS = 5000;

    private final OperatorContext context;
    private final Command stop;
    private final Command release;
    private final Command confirm;
    private final Timer expiry = new Timer(SECOND_STEP_MS, this::expired);
    private Optional<String> notSent = Optional.empty();
    private int presses;
    private boolean sending;
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
        context.models().fleetStop().addListener(this::stateChanged);
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

    /** Whether the session says that boats are stopped. */
    boolean isStopped() {
        return context.models().fleetStop().snapshot().isLatched();
    }

    /** Whether that is the state of the whole fleet, and not of single boats. */
    boolean isOfFleet() {
        return context.models().fleetStop().snapshot().isOfFleet();
    }

    /** Whether a stop was pressed, and the session has not answered yet. */
    boolean isSending() {
        return sending;
    }

    /** Why the last stop could not be sent; empty where it was, or the fleet was stopped or released since. */
    Optional<String> whyNotSent() {
        return notSent;
    }

    boolean isReleasing() {
        return releasing;
    }

    private void stopAll() {
        int press = ++presses;
        sending = true;
        releasing = false;
        refresh();
        context.session().fleet().stopAll().whenComplete((boats, fault) -> answered(press, fault));
    }

    private void answered(int press, @Nullable Throwable fault) {
        if (press != presses) {
            return; // the answer to the last press counts
        }
        sending = false;
        notSent = Optional.ofNullable(fault).map(RefusedException::reason);
        notSent.ifPresentOrElse(
                why -> context.notices().refused("The fleet stop was NOT sent: " + why),
                () -> context.notices().show("Fleet stop: stop sent to every boat"));
        refresh();
    }

    private void stateChanged(FleetStopState state) {
        if (state.isOfFleet()) {
            notSent = Optional.empty();
        }
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
        releasing = false;
        notSent = Optional.empty();
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
