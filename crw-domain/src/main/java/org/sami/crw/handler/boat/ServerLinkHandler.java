package org.sami.crw.handler.boat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/**
 * Disconnect Server and Reconnect Server (field plans): closes or reopens the links to the boats' servers. The boats' tokens stay and their commands
 * wait; a disconnected boat starts its lost-link action.
 */
public final class ServerLinkHandler implements ActivationHandler {
    public static final String DISCONNECT = "DisconnectServer";
    public static final String RECONNECT = "ReconnectServer";

    private final ProxyRegistry boats;
    private final Consumer<BoatProxy> change;

    private ServerLinkHandler(ProxyRegistry boats, Consumer<BoatProxy> change) {
        this.boats = boats;
        this.change = change;
    }

    public static ServerLinkHandler disconnecting(ProxyRegistry boats) {
        return new ServerLinkHandler(boats, BoatProxy::disconnect);
    }

    public static ServerLinkHandler reconnecting(ProxyRegistry boats) {
        return new ServerLinkHandler(boats, BoatProxy::reconnect);
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<String> unknown = new ArrayList<>();
        for (Addressee addressee : Addressee.of(activation, context)) {
            Optional<BoatProxy> boat = boats.find(addressee.boat());
            boat.ifPresentOrElse(change, () -> unknown.add(addressee.boat()));
        }
        if (!unknown.isEmpty()) {
            throw new IllegalStateException(MotionCommands.UNKNOWN_BOAT + ": " + String.join(", ", unknown));
        }
    }
}
