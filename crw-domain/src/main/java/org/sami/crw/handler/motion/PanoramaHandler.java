package org.sami.crw.handler.motion;

import java.util.List;
import java.util.Optional;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.proxy.command.Panorama;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/**
 * Take Panorama (thesis 9.1.2): each boat keeps its station, turns all round and takes pictures; it answers when they are taken. They
 * stay on board.
 */
public final class PanoramaHandler implements ActivationHandler {
    public static final String TYPE = "TakePanorama";
    private static final int PICTURES = 8; // a phone's camera sees some 60 degrees: enough to overlap

    private final MotionCommands motion;

    public PanoramaHandler(MotionCommands motion) {
        this.motion = motion;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<Move> moves = Addressee.of(activation, context).stream()
                .map(addressee -> new Move(
                        addressee,
                        new Panorama(
                                Move.commandId(activation, addressee),
                                activation.mission(),
                                activation.id(),
                                PICTURES,
                                activation.priority()),
                        Optional.empty(),
                        Reply.PICTURES_IF_AWAITED))
                .toList();
        motion.send(activation, context, moves);
    }
}
