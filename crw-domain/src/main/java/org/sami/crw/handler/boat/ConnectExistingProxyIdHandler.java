package org.sami.crw.handler.boat;

import java.util.List;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.proxy.BoatConnector;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Connect Existing Proxy Id: as Connect Existing Proxy, of a boat whose id says its name, colour and address. */
public final class ConnectExistingProxyIdHandler implements ActivationHandler {
    public static final String TYPE = "ConnectExistingProxyId";
    private static final String ID = "boatId";

    private final BoatConnector connector;
    private final NewBoats newBoats;

    public ConnectExistingProxyIdHandler(BoatConnector connector, NewBoats newBoats) {
        this.connector = connector;
        this.newBoats = newBoats;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        Value id = ActivationFields.required(activation, ID);
        if (!(id instanceof RecordValue boatId)) {
            throw new IllegalArgumentException("\"" + ID + "\" is no boat id: " + id);
        }
        BoatConnector.Request wanted =
                new BoatConnector.Request(text(boatId, "name"), text(boatId, "color"), text(boatId, "server"));
        connector.connect(wanted, boat -> newBoats.await(activation, List.of(boat), context));
    }

    private static String text(RecordValue boatId, String field) {
        return boatId.fields().get(field) instanceof TextValue text ? text.value() : "";
    }
}
