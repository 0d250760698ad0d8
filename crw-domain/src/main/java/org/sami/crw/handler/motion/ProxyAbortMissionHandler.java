package org.sami.crw.handler.motion;

import org.sami.crw.handler.activation.Addressee;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/** Proxy Abort Mission: what this mission has commanded is withdrawn from the entering boats, its block too. */
public final class ProxyAbortMissionHandler implements ActivationHandler {
    public static final String TYPE = "ProxyAbortMission";

    private final Aborts aborts;

    public ProxyAbortMissionHandler(Aborts aborts) {
        this.aborts = aborts;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        for (Addressee addressee : Addressee.of(activation, context)) {
            aborts.withdraw(activation.mission(), addressee.boat());
        }
    }
}
