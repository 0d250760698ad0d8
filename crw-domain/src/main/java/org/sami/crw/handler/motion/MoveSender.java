package org.sami.crw.handler.motion;

import java.util.List;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/** What becomes of moves that were asked about. */
interface MoveSender {
    /** The operator wants them, and knows what is wrong. */
    void send(Activation activation, HandlerContext context, List<Move> moves);

    /** A robot in the air comes home and lands, without a question. */
    void sendHome(Activation activation, HandlerContext context, String robot);

    /** The operator does not want it. */
    void refuse(Activation activation, HandlerContext context, Move move, String reason);
}
