package org.sami.crw.handler.motion;

import org.sami.crw.handler.activation.Addressee;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/**
 * Proxy Emergency Abort: the entering boats stop their motors at once, and all that any mission has for them fails: commands
 * in their queues, and moves that wait or are computed.
 */
public final class EmergencyAbortHandler implements ActivationHandler {
    public static final String TYPE = "ProxyEmergencyAbort";

    private final Aborts aborts;

    public EmergencyAbortHandler(Aborts aborts) {
        this.aborts = aborts;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        for (Addressee addressee : Addressee.of(activation, context)) {
            aborts.stop(addressee.boat(), "mission " + activation.mission() + " stopped the boat");
        }
    }
}
