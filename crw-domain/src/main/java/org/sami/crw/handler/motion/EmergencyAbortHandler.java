package org.sami.crw.handler.motion;

import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/**
 * Proxy Emergency Abort: the entering boats stop their motors at once, and all commands in their queues, of whatever mission, fail.
 */
public final class EmergencyAbortHandler implements ActivationHandler {
    public static final String TYPE = "ProxyEmergencyAbort";

    private final ProxyRegistry boats;

    public EmergencyAbortHandler(ProxyRegistry boats) {
        this.boats = boats;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        for (Addressee addressee : Addressee.of(activation, context)) {
            boats.find(addressee.boat())
                    .ifPresent(boat -> boat.abort("mission " + activation.mission() + " stopped the boat"));
        }
    }
}
