package org.sami.crw.gui.boat;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.swing.Timer;
import org.sami.boat.link.BoatMode;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.session.api.RefusedException;
import org.sami.ui.command.Command;

/**
 * Tries the motor of the selected boat before it is launched: a little thrust for a second, then it is given back. Keeps the greatest speed that
 * was seen. On the event thread.
 */
final class MotorTrial {
    private static final int PERIOD_MS = 200;
    private static final int TIMES = 5;
    private static final double THRUST = 0.25;

    private final OperatorContext context;
    private final Command command;
    private final Map<String, Double> seenMps = new HashMap<>();
    private final Timer timer = new Timer(PERIOD_MS, e -> step());
    private Optional<String> boat = Optional.empty();
    private int left;

    MotorTrial(OperatorContext context) {
        this.context = context;
        command = context.commands()
                .add(new Command("boat-try-motor", "Try the motor", this::begin)
                        .withKey("ctrl shift Y")
                        .withIcon("play")
                        .unless(this::whyNot));
        context.boats().addListener(command::refresh);
    }

    Command command() {
        return command;
    }

    /** Gives a boat whose motor is tried now back to the missions: the window is closed. */
    void close() {
        boat.ifPresent(this::end);
    }

    /** The greatest speed in m/s of a boat's last trial; empty where it was not tried. */
    OptionalDouble seenMps(String which) {
        return seenMps.containsKey(which) ? OptionalDouble.of(seenMps.get(which)) : OptionalDouble.empty();
    }

    private Optional<String> whyNot() {
        if (boat.isPresent()) {
            return Optional.of("the motor of " + boat.get() + " is tried now");
        } else if (context.boats().boats().size() != 1) {
            return Optional.of("select one boat first");
        }
        Optional<BoatSnapshot> selected =
                context.models().fleet().boat(context.boats().boats().get(0));
        if (selected.flatMap(BoatSnapshot::mode)
                .filter(BoatMode.FLEET_STOP::equals)
                .isPresent()) {
            return Optional.of("its motors are stopped, release it first");
        }
        if (selected.map(BoatSnapshot::commander)
                .filter(Commander.BY_HAND::equals)
                .isPresent()) {
            return Optional.of("it is driven by hand");
        }
        return selected.flatMap(BoatSnapshot::command)
                .map(wanted -> "it carries out a command of " + context.titles().words(wanted.mission()));
    }

    private void begin() {
        boat = context.boats().first();
        left = TIMES;
        boat.ifPresent(which -> seenMps.put(which, 0.0));
        context.notices().show("Motor of " + boat.orElse("") + ": 25 % thrust for one second; keep clear");
        timer.start();
        step();
    }

    private void step() {
        String which = boat.orElseThrow();
        context.models()
                .fleet()
                .boat(which)
                .flatMap(BoatSnapshot::pose)
                .ifPresent(pose -> seenMps.merge(which, Math.abs(pose.speedMps()), Math::max));
        if (left-- > 0) {
            context.session().fleet().teleoperate(which, THRUST, 0).whenComplete((sent, fault) -> {
                if (fault != null) {
                    seenMps.remove(which);
                    context.notices()
                            .refused("The motor of " + which + " cannot be tried: " + RefusedException.reason(fault));
                    end(which);
                }
            });
        } else {
            end(which);
        }
    }

    private void end(String which) {
        if (boat.isPresent()) {
            timer.stop();
            boat = Optional.empty();
            context.session().fleet().handBack(which);
            command.refresh();
        }
    }
}
