package org.sami.crw.handler;

import java.util.List;
import org.sami.crw.proxy.BoatConnector;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/** Connect Existing Proxy: connects to a boat's server by its address; Proxy Created answers when the boat has joined. */
final class ConnectExistingProxyHandler implements ActivationHandler {
    static final String TYPE = "ConnectExistingProxy";

    private final BoatConnector connector;
    private final NewBoats newBoats;

    ConnectExistingProxyHandler(BoatConnector connector, NewBoats newBoats) {
        this.connector = connector;
        this.newBoats = newBoats;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        BoatConnector.Wanted wanted = new BoatConnector.Wanted(
                ActivationFields.text(activation, "name"),
                ActivationFields.text(activation, "color"),
                ActivationFields.text(activation, "server"));
        connector.connect(wanted, boat -> newBoats.await(activation, List.of(boat), context));
    }
}
