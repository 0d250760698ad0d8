package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.proxy.command.Stop;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/**
 * Block Movement: the boats stop and wait for this mission's next command; the block ends with the mission. Where the mission has
 * ended already (its end place asks for it), they stop and are not kept. Each answers when it has stopped.
 */
public final class BlockMovementHandler implements ActivationHandler {
    public static final String TYPE = "BlockMovement";

    private final MotionCommands motion;

    public BlockMovementHandler(MotionCommands motion) {
        this.motion = motion;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        boolean running = Move.mayBlock(activation, context);
        List<Move> moves = new ArrayList<>();
        for (Addressee addressee : Addressee.of(activation, context)) {
            Stop stop = new Stop(
                    Move.commandId(activation, addressee),
                    activation.mission(),
                    activation.id(),
                    activation.priority(),
                    running);
            moves.add(new Move(addressee, stop, Optional.empty(), running ? Reply.STOP_IF_AWAITED : Reply.NONE));
        }
        motion.send(activation, context, moves);
    }
}
