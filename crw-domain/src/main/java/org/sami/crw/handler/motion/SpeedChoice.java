package org.sami.crw.handler.motion;

import java.util.Optional;
import org.sami.crw.handler.activation.Markups;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.choice.Criterion;
import org.sami.spn.protocol.Activation;

/**
 * How fast boats drive by the markup Optimize on an event that moves them: for execution time at twice the cruise speed (thesis 8.1),
 * else at cruise speed. A path that has a speed of its own keeps it.
 */
final class SpeedChoice {
    private static final double FACTOR = 2;

    private SpeedChoice() {}

    /** The command at the speed that the activation asks for. */
    static BoatCommand of(Activation activation, BoatCommand command, BoatProxy boat) {
        return isFast(activation)
                        && command instanceof FollowPath path
                        && path.speedMps().isEmpty()
                ? path.atSpeed(FACTOR * boat.cruiseSpeedMps())
                : command;
    }

    /** What is to be said of it. */
    static Optional<String> words(Activation activation) {
        return isFast(activation)
                ? Optional.of(activation.place() + ": boats drive at twice the cruise speed, for execution time")
                : Optional.empty();
    }

    private static boolean isFast(Activation activation) {
        return Markups.criterion(activation)
                .filter(criterion -> criterion == Criterion.EXECUTION_TIME)
                .isPresent();
    }
}
