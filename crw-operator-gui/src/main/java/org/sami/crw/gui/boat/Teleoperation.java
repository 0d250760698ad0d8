package org.sami.crw.gui.boat;

import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.Timer;
import org.sami.boat.link.BoatMode;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.crw.operator.boat.FleetStopState;
import org.sami.session.api.RefusedException;
import org.sami.spn.host.Registration;
import org.sami.ui.command.Command;

/**
 * Drives one boat by the arrow keys, or by a stick on the screen: up and down are thrust, left and right the rudder. Missions are notified that a person drives the boat;
 * the same command or Escape gives it back, and a stop ends it. While no key and no stick is held the boat is commanded to stand, as it is once the window has lost the keyboard;
 * without this window it stops by itself. On the event thread.
 */
final class Teleoperation implements StickView.Driver {
    private static final int PERIOD_MS = 200; // the boat stops two seconds after the last
    private static final double THRUST = 0.6;
    private static final double RUDDER = 0.8;

    private final OperatorContext context;
    private final Command command;
    private final ArrowKeys keys = new ArrowKeys(this::giveBack, this::keyboardLost);
    private final Timer timer = new Timer(PERIOD_MS, e -> send());
    private final List<Runnable> listeners = new ArrayList<>();
    private final Registration stops;
    private Optional<String> boat = Optional.empty();
    private double stickThrust;
    private double stickRudder;

    Teleoperation(OperatorContext context) {
        this.context = context;
        command = new Command("boat-by-hand", "Drive by hand", this::toggle)
                .withKey("ctrl shift D")
                .withIcon("hand")
                .unless(this::whyNotToggle);
        if (isOffered()) {
            context.commands().add(command);
        }
        stops = context.models().fleetStop().addListener(this::stopChanged);
    }

    private Optional<String> whyNotToggle() {
        List<String> selected = context.boats().boats();
        if (boat.isPresent()) {
            return Optional.empty();
        } else if (selected.size() != 1) {
            return Optional.of("select one boat first");
        }
        if (context.flies(selected.get(0))) {
            return Optional.of("it flies: its own radio control takes it over, or send it somewhere");
        }
        return context.models().fleetStop().snapshot().stops(selected.get(0))
                ? Optional.of("its motors are stopped, release it first")
                : Optional.empty();
    }

    Command command() {
        return command;
    }

    /** Whether robots of the session are driven by hand at all: what flies is not. */
    boolean isOffered() {
        return context.robots() != RobotKind.COPTER;
    }

    /** Calls a listener when driving begins or ends, and when the boat is to stand though the stick may be held. */
    void addListener(Runnable listener) {
        listeners.add(listener);
    }

    /** The boat that is driven. */
    Optional<String> driven() {
        return boat;
    }

    @Override
    public Optional<String> whyNot() {
        return command.whyNot();
    }

    /** Whether the stick is to be let go: the boat stands. */
    boolean isStickFree() {
        return stickThrust == 0 && stickRudder == 0;
    }

    @Override
    public boolean grasp() {
        if (boat.isEmpty()) {
            command.run();
        }
        return boat.isPresent();
    }

    @Override
    public void stands(double thrust, double rudder) {
        stickThrust = thrust;
        stickRudder = rudder;
        send();
    }

    /** Gives the boat back, and listens to nothing any longer: the window is closed. */
    void close() {
        stops.close();
        giveBack();
    }

    private void toggle() {
        if (boat.isPresent()) {
            giveBack();
        } else {
            begin(context.boats().boats().get(0));
        }
    }

    private void begin(String which) {
        boat = Optional.of(which);
        stand();
        keys.start();
        send();
        timer.start();
        context.notices()
                .show("You drive " + which + ": arrow keys or the stick; Escape or " + command.keyText()
                        + " gives it back");
        tell();
    }

    private void giveBack() {
        boat.ifPresent(which -> {
            end();
            context.tell(context.session().fleet().handBack(which), which + " is given back to the missions");
        });
    }

    /** Gives the boat back without a notice, for those who have said why. */
    private void endSaid() {
        boat.ifPresent(which -> {
            end();
            context.session().fleet().handBack(which);
        });
    }

    private void end() {
        timer.stop();
        keys.stop();
        stand();
        boat = Optional.empty();
        command.refresh();
        tell();
    }

    private void stand() {
        stickThrust = 0;
        stickRudder = 0;
    }

    private void tell() {
        listeners.forEach(Runnable::run);
    }

    private void keyboardLost() {
        stand();
        send();
        tell();
        boat.ifPresent(which -> context.notices()
                .refused(which + " is told to stand: another window has the keyboard. Press the keys, or the stick,"
                        + " anew; Escape gives it back"));
    }

    private void stopChanged(FleetStopState state) {
        command.refresh();
        boat.filter(state::stops).ifPresent(which -> {
            context.notices().refused(which + " is stopped: driving by hand has ended");
            endSaid();
        });
    }

    private void send() {
        boat.ifPresent(which -> {
            double thrust = axis(KeyEvent.VK_UP, KeyEvent.VK_DOWN, stickThrust) * THRUST;
            double rudder = axis(KeyEvent.VK_RIGHT, KeyEvent.VK_LEFT, stickRudder) * RUDDER;
            context.session().fleet().teleoperate(which, thrust, rudder).whenComplete((sent, fault) -> {
                if (!boat.equals(Optional.of(which))) {
                    return; // it has ended since, and why was said
                }
                if (fault != null) {
                    context.notices().refused(which + " cannot be driven: " + RefusedException.reason(fault));
                    endSaid();
                } else if ((thrust != 0 || rudder != 0) && goesByHand(which)) {
                    context.notices()
                            .show(String.format(
                                    Locale.ROOT,
                                    "%s by hand: thrust %+.0f %%, rudder %+.0f %%",
                                    which,
                                    thrust * 100,
                                    rudder * 100));
                }
            });
        });
    }

    /** Whether the boat says so: what was sent to it is not what it does. */
    private boolean goesByHand(String which) {
        Optional<BoatSnapshot> now = context.models().fleet().boat(which);
        return now.map(BoatSnapshot::commander)
                        .filter(Commander.BY_HAND::equals)
                        .isPresent()
                && now.flatMap(BoatSnapshot::mode)
                        .filter(BoatMode.FLEET_STOP::equals)
                        .isEmpty();
    }

    /** A key that is held counts more than the stick. */
    private double axis(int plus, int minus, double stick) {
        int keyed = keys.axis(plus, minus);
        return keyed == 0 ? stick : keyed;
    }
}
