package org.sami.crw.gui.boat;

import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import javax.swing.Timer;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.ui.command.Command;

/**
 * Drives one boat by the arrow keys, or by a stick on the screen: up and down are thrust, left and right the rudder. Missions are notified that a person drives the boat;
 * the same command or Escape gives it back. While no key and no stick is held the boat is commanded to stop; without this window it stops by itself.
 */
final class Teleoperation {
    private static final int PERIOD_MS = 200; // the boat stops two seconds after the last
    private static final double THRUST = 0.6;
    private static final double RUDDER = 0.8;
    private static final Set<Integer> KEYS =
            Set.of(KeyEvent.VK_UP, KeyEvent.VK_DOWN, KeyEvent.VK_LEFT, KeyEvent.VK_RIGHT);

    private final OperatorContext context;
    private final Command command;
    private final Set<Integer> held = new HashSet<>();
    private final Timer timer = new Timer(PERIOD_MS, e -> send());
    private final KeyEventDispatcher keys = this::onKey;
    private final List<Runnable> listeners = new ArrayList<>();
    private Optional<String> boat = Optional.empty();
    private double stickThrust;
    private double stickRudder;

    Teleoperation(OperatorContext context) {
        this.context = context;
        command = context.commands()
                .add(new Command("boat-by-hand", "Drive by hand", this::toggle)
                        .withKey("ctrl shift D")
                        .withIcon("hand")
                        .unless(() ->
                                boat.isPresent() || context.boats().boats().size() == 1
                                        ? Optional.empty()
                                        : Optional.of("select one boat first")));
    }

    Command command() {
        return command;
    }

    /** Calls a listener when driving begins or ends. */
    void addListener(Runnable listener) {
        listeners.add(listener);
    }

    /** The boat that is driven. */
    Optional<String> driven() {
        return boat;
    }

    /** Why nothing can be driven now; empty where something is, or can be. */
    Optional<String> whyNot() {
        return command.whyNot();
    }

    /**
     * The stick stands so from now on; begins to drive the selected boat where none is driven.
     *
     * @param thrust part of what keys give, -1 to 1
     * @param rudder part of what keys give, -1 (port) to 1 (starboard)
     */
    void steer(double thrust, double rudder) {
        if (boat.isEmpty() && command.whyNot().isEmpty() && (thrust != 0 || rudder != 0)) {
            command.run();
        }
        stickThrust = thrust;
        stickRudder = rudder;
        send();
    }

    private void toggle() {
        if (boat.isPresent()) {
            end();
        } else {
            begin(context.boats().boats().get(0));
        }
    }

    private void begin(String which) {
        boat = Optional.of(which);
        held.clear();
        stickThrust = 0;
        stickRudder = 0;
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(keys);
        send();
        timer.start();
        context.notices()
                .show("You drive " + which + ": arrow keys or the stick; Escape or " + command.keyText()
                        + " gives it back");
        listeners.forEach(Runnable::run);
    }

    private void end() {
        timer.stop();
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(keys);
        boat.ifPresent(which ->
                context.tell(context.session().fleet().handBack(which), which + " is given back to the missions"));
        boat = Optional.empty();
        listeners.forEach(Runnable::run);
    }

    private boolean onKey(KeyEvent event) {
        if (event.getID() == KeyEvent.KEY_PRESSED && event.getKeyCode() == KeyEvent.VK_ESCAPE) {
            end();
            return true;
        }
        if (!KEYS.contains(event.getKeyCode())) {
            return false;
        }
        if (event.getID() == KeyEvent.KEY_PRESSED) {
            held.add(event.getKeyCode());
        } else if (event.getID() == KeyEvent.KEY_RELEASED) {
            held.remove(event.getKeyCode());
        }
        return true;
    }

    private void send() {
        boat.ifPresent(which -> {
            double thrust = axis(KeyEvent.VK_UP, KeyEvent.VK_DOWN, stickThrust) * THRUST;
            double rudder = axis(KeyEvent.VK_RIGHT, KeyEvent.VK_LEFT, stickRudder) * RUDDER;
            context.session().fleet().teleoperate(which, thrust, rudder).whenComplete((sent, fault) -> {
                if (fault != null) {
                    context.notices().refused(which + " cannot be driven: " + fault.getMessage());
                    end();
                } else if (thrust != 0 || rudder != 0) {
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

    /** A key that is held counts more than the stick. */
    private double axis(int plus, int minus, double stick) {
        int keyed = (held.contains(plus) ? 1 : 0) - (held.contains(minus) ? 1 : 0);
        return keyed == 0 ? stick : keyed;
    }
}
