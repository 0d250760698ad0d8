package org.sami.crw.handler;

import java.util.Objects;
import java.util.Optional;
import org.sami.crw.proxy.BoatCommand;
import org.sami.spn.protocol.Activation;

/**
 * A command for one boat that an activation asks for.
 *
 * @param progressKey under which the mission remembers how many points are visited; empty = it does not
 * @param answered whether the plan is told of completion and failure
 */
record Move(Addressee addressee, BoatCommand command, Optional<String> progressKey, boolean answered) {
    Move {
        Objects.requireNonNull(addressee, "addressee");
        Objects.requireNonNull(command, "command");
        Objects.requireNonNull(progressKey, "progressKey");
    }

    /** The command's id: the same whenever the activation is delivered, and no other's. */
    static String commandId(Activation activation, Addressee addressee) {
        return "m" + activation.mission() + "-a" + activation.id() + "-" + addressee.boat();
    }
}
