package org.sami.crw.handler.motion;

import org.sami.crw.handler.activation.Addressee;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/**
 * Proxy Resend Waypoints: what each boat is to do now goes to it once more (thesis 6.3.4: it brought boats back that had lost their
 * base). Answers when the boat has come to the end of it, as the command itself does.
 */
public final class ResendWaypointsHandler implements ActivationHandler {
    public static final String TYPE = "ProxyResendWaypoints";

    private final MotionCommands motion;

    public ResendWaypointsHandler(MotionCommands motion) {
        this.motion = motion;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        motion.sendAgain(activation, context, Addressee.of(activation, context));
    }
}
