package org.sami.crw.handler.boat;

import java.util.List;
import org.sami.crw.decision.BoatDescriptions;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.TextValue;

/** Proxy Set Description: describes each boat in a word, kept in the session's journal; the markup Filter selects by it (6.3.2). */
public final class SetDescriptionHandler implements ActivationHandler {
    public static final String TYPE = "ProxySetDescription";
    private static final String DESCRIPTION = "description";

    @Override
    public void handle(Activation activation, HandlerContext context) {
        if (!(ActivationFields.required(activation, DESCRIPTION) instanceof TextValue text)) {
            throw new IllegalArgumentException("\"" + DESCRIPTION + "\" is no text: " + activation.value(DESCRIPTION));
        }
        List<Input> inputs = Addressee.of(activation, context).stream()
                .map(addressee -> BoatDescriptions.remember(addressee.boat(), text.value()))
                .toList();
        if (!inputs.isEmpty()) {
            context.post(inputs);
        }
    }
}
