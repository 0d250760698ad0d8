package org.sami.crw.gui.boat;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.swing.Timer;
import org.sami.boat.link.BoatMode;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.session.api.RefusedException;
import org.sami.ui.command.Command;

/**
 * Tries the motor of the selected boat before it is launched: a little thrust for a second, then it is given back. Keeps the greatest speed that
 * was seen, of trials that the boat obeyed: it says that it is driven, or it moves. Nobody tries the motors of what flies. On the event thread.
 */
final class MotorTrial {
    private static final int PERIOD_MS = 200;
    private static final int TIMES = 5;
    private static final int AWAITED_TIMES = 10; // a boat far away says late that it is driven
    private static final double THRUST = 0.25;
    private static final double MOVES_MPS = 0.1;

    private final OperatorContext context;
    private final Command command;
    private final Map<String, Double> seenMps = new HashMap<>();
    private final Timer timer = new Timer(PERIOD_MS, e -> step());
    private Optional<String> boat = Optional.empty();
    private int left; // of the times that thrust is asked for; below 0 its obedience is awaited
    private boolean obeyed;
    private double fastestMps;

    MotorTrial(OperatorContext context) {
        this.context = context;
        command = new Command("boat-try-motor", "Try the motor", this::begin)
                .withKey("ctrl shift Y")
                .withIcon("play")
                .unless(this::whyNot);
        if (context.robots() != RobotKind.COPTER) {
            context.commands().add(command);
        }
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
        if (context.flies(context.boats().boats().get(0))) {
            return Optional.of("it flies: its motors are not tried on the ground");
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
        boat.ifPresent(seenMps::remove); // the last trial counts, also one that comes to nothing
        left = TIMES;
        obeyed = false;
        fastestMps = 0;
        context.notices().show("Motor of " + boat.orElse("") + ": 25 % thrust for one second; keep clear");
        timer.start();
        step();
    }

    private void step() {
        String which = boat.orElseThrow();
        context.models().fleet().boat(which).ifPresent(this::look);
        if (left > 0 || (!obeyed && left > -AWAITED_TIMES)) {
            context.session()
                    .fleet()
                    .teleoperate(which, left > 0 ? THRUST : 0, 0)
                    .whenComplete((sent, fault) -> {
                        if (fault != null && boat.equals(Optional.of(which))) {
                            refused(which, RefusedException.reason(fault));
                        }
                    });
            left--;
        } else if (obeyed) {
            seenMps.put(which, fastestMps);
            end(which);
        } else {
            refused(which, "it does not do what it is told");
        }
    }

    private void look(BoatSnapshot now) {
        double mps = now.pose().map(pose -> Math.abs(pose.speedMps())).orElse(0.0);
        fastestMps = Math.max(fastestMps, mps);
        obeyed |= now.mode().filter(BoatMode.TELEOPERATION::equals).isPresent() || mps >= MOVES_MPS;
    }

    private void refused(String which, String why) {
        context.notices().refused("The motor of " + which + " cannot be tried: " + why);
        end(which);
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
