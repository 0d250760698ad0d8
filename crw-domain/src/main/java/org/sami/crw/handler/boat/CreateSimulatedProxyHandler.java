package org.sami.crw.handler.boat;

import org.sami.crw.event.Numbers;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.proxy.BoatConnector;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;

/** Create Simulated Proxy: makes simulated boats; Proxy Created answers, naming all, when the last has joined. */
public final class CreateSimulatedProxyHandler implements ActivationHandler {
    public static final String TYPE = "CreateSimulatedProxy";

    private final BoatConnector connector;
    private final NewBoats newBoats;

    public CreateSimulatedProxyHandler(BoatConnector connector, NewBoats newBoats) {
        this.connector = connector;
        this.newBoats = newBoats;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        double count = Numbers.real(ActivationFields.required(activation, "numberToCreate"));
        if (count < 1 || count > BoatConnector.MOST_CREATED) {
            throw new IllegalArgumentException(
                    "\"numberToCreate\" is 1 to " + BoatConnector.MOST_CREATED + ", not " + (long) count);
        }
        newBoats.await(
                activation,
                connector.create(
                        ActivationFields.text(activation, "name"),
                        ActivationFields.text(activation, "color"),
                        ActivationFields.point(activation, "startLocation"),
                        (int) count),
                context);
    }
}
