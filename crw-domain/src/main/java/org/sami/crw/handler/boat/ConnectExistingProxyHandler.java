package org.sami.crw.handler.boat;

import java.util.List;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.proxy.BoatConnector;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/** Connect Existing Proxy: connects to a boat's server by its address; Proxy Created answers when the boat has joined. */
public final class ConnectExistingProxyHandler implements ActivationHandler {
    public static final String TYPE = "ConnectExistingProxy";

    private final BoatConnector connector;
    private final NewBoats newBoats;

    public ConnectExistingProxyHandler(BoatConnector connector, NewBoats newBoats) {
        this.connector = connector;
        this.newBoats = newBoats;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        BoatConnector.Request wanted = new BoatConnector.Request(
                ActivationFields.text(activation, "name"),
                ActivationFields.text(activation, "color"),
                ActivationFields.text(activation, "server"));
        connector.connect(wanted, boat -> newBoats.await(activation, List.of(boat), context));
    }
}
