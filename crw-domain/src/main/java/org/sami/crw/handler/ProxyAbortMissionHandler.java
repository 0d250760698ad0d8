package org.sami.crw.handler;

import java.util.List;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/** Proxy Abort Mission: what this mission has commanded is withdrawn from the entering boats, its block too. */
final class ProxyAbortMissionHandler implements ActivationHandler {
    static final String TYPE = "ProxyAbortMission";

    private final MotionCommands motion;

    ProxyAbortMissionHandler(MotionCommands motion) {
        this.motion = motion;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        for (Addressee addressee : Addressee.of(activation, context)) {
            motion.withdraw(activation.mission(), List.of(addressee.boat()));
        }
    }
}
