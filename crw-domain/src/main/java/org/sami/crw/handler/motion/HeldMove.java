package org.sami.crw.handler.motion;

import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/** A move that is not sent yet, and who asked for it. */
record HeldMove(Activation activation, HandlerContext context, Move move) {
    long mission() {
        return activation.mission();
    }

    /** The boat's id. */
    String boat() {
        return move.addressee().boat();
    }
}
