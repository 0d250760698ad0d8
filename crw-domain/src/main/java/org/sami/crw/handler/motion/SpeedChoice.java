package org.sami.crw.handler.motion;

import java.util.Optional;
import org.sami.crw.handler.activation.Markups;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.choice.Criterion;
import org.sami.spn.protocol.Activation;

/**
 * How fast boats drive by the markup Optimize on an event that moves them: for execution time at twice the cruise speed (thesis 8.1), for execution efficiency, where
 * a boat says how its consumption depends on speed, at the speed of which a metre costs least, between half the cruise speed and the whole; else at cruise speed. A path that
 * has a speed of its own keeps it.
 */
public final class SpeedChoice {
    private static final double FAST = 2;
    private static final double SLOW = 0.5;

    private SpeedChoice() {}

    /** The command at the speed that the activation asks for. */
    static BoatCommand of(Activation activation, BoatCommand command, BoatProxy boat) {
        double mps = mps(activation, boat);
        return mps != boat.cruiseSpeedMps()
                        && command instanceof FollowPath path
                        && path.speedMps().isEmpty()
                ? path.atSpeed(mps)
                : command;
    }

    /** The speed in m/s at which a boat carries out a command of an activation. */
    static double mps(Activation activation, BoatCommand command, BoatProxy boat) {
        return command instanceof FollowPath path && path.speedMps().isPresent()
                ? path.speedMps().getAsDouble()
                : mps(activation, boat);
    }

    /** The speed in m/s of a boat on paths of an activation that name none. */
    public static double mps(Activation activation, BoatProxy boat) {
        double cruise = boat.cruiseSpeedMps();
        if (asksFor(activation, Criterion.EXECUTION_TIME)) {
            return FAST * cruise;
        }
        return asksFor(activation, Criterion.EXECUTION_EFFICIENCY)
                ? boat.performance()
                        .power()
                        .map(power -> power.economicMps(SLOW * cruise, cruise))
                        .orElse(cruise)
                : cruise;
    }

    /** What is to be said of it. */
    static Optional<String> words(Activation activation) {
        return asksFor(activation, Criterion.EXECUTION_TIME)
                ? Optional.of(activation.place() + ": boats drive at twice the cruise speed, for execution time")
                : Optional.empty();
    }

    private static boolean asksFor(Activation activation, Criterion wanted) {
        return Markups.criterion(activation)
                .filter(criterion -> criterion == wanted)
                .isPresent();
    }
}
