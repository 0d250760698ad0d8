package org.sami.crw.handler.motion;

import java.util.List;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/** What becomes of moves that were asked about. */
interface MoveSender {
    /** The operator wants them, or there is nothing to ask. */
    void send(Activation activation, HandlerContext context, List<Move> moves);

    /** They go without a question, clear of what the plan avoids: robots come home. */
    void sendHome(Activation activation, HandlerContext context, List<Move> moves);

    /** The operator does not want it. */
    void refuse(Activation activation, HandlerContext context, Move move, String reason);
}
