package org.sami.uav.handler;

import java.util.List;
import java.util.Optional;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.handler.motion.Move;
import org.sami.crw.handler.motion.Reply;
import org.sami.crw.proxy.command.Panorama;
import org.sami.crw.proxy.command.Stop;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/** Hover and Look Around: each aircraft stays where it is in the air, and for the latter turns all round and takes pictures. */
final class HoverHandler implements ActivationHandler {
    private static final int PICTURES = 8; // of a lens of 70 degrees: enough to overlap
    private static final Reply HOVERING = new Reply(UavEvents.HOVERING, "", "", true);

    private final MotionCommands motion;
    private final boolean looks;

    private HoverHandler(MotionCommands motion, boolean looks) {
        this.motion = motion;
        this.looks = looks;
    }

    static HoverHandler staying(MotionCommands motion) {
        return new HoverHandler(motion, false);
    }

    static HoverHandler looking(MotionCommands motion) {
        return new HoverHandler(motion, true);
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<Move> moves = Addressee.of(activation, context).stream()
                .map(aircraft -> looks ? look(activation, aircraft) : stay(activation, aircraft, HOVERING, ""))
                .toList();
        motion.send(activation, context, moves);
    }

    /**
     * Has an aircraft stay where it is.
     *
     * @param suffix of the command's id, where the activation gives it another command too
     */
    static Move stay(Activation activation, Addressee aircraft, Reply reply, String suffix) {
        Stop stop = new Stop(
                Move.commandId(activation, aircraft) + suffix,
                activation.mission(),
                activation.id(),
                activation.priority(),
                false);
        return new Move(aircraft, stop, Optional.empty(), reply);
    }

    private static Move look(Activation activation, Addressee aircraft) {
        Panorama panorama = new Panorama(
                Move.commandId(activation, aircraft),
                activation.mission(),
                activation.id(),
                PICTURES,
                activation.priority());
        Reply reply = new Reply("", UavEvents.CANNOT_FLY, UavEvents.PICTURE_TAKEN, true);
        return new Move(aircraft, panorama, Optional.empty(), reply);
    }
}
