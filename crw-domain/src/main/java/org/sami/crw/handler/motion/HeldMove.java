package org.sami.crw.handler.motion;

import java.util.List;
import java.util.Optional;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.TaskId;

/** A move that is not sent yet, and who asked for it. */
record HeldMove(Activation activation, HandlerContext context, Move move) {
    long mission() {
        return activation.mission();
    }

    /** The same without tasks of these names; empty where it is for them alone. */
    Optional<HeldMove> without(List<TaskId> names) {
        return move.addressee().without(names).map(left -> new HeldMove(activation, context, move.with(left)));
    }

    /** The boat's id. */
    String boat() {
        return move.addressee().boat();
    }
}
