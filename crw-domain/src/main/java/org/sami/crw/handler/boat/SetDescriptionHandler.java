package org.sami.crw.handler.boat;

import java.util.ArrayList;
import java.util.List;
import org.sami.crw.decision.BoatDescriptions;
import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.CommandMemory;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.TextValue;

/**
 * Proxy Set Description: describes each boat in a word, kept in the session's journal; the markup Filter selects by it (6.3.2). A base that goes on with the
 * mission does not describe it again: it may have another description since.
 */
public final class SetDescriptionHandler implements ActivationHandler {
    public static final String TYPE = "ProxySetDescription";
    private static final String DESCRIPTION = "description";

    @Override
    public void handle(Activation activation, HandlerContext context) {
        if (!(ActivationFields.required(activation, DESCRIPTION) instanceof TextValue text)) {
            throw new IllegalArgumentException("\"" + DESCRIPTION + "\" is no text: " + activation.value(DESCRIPTION));
        }
        List<Input> inputs = new ArrayList<>();
        for (Addressee addressee : Addressee.of(activation, context)) {
            String id = CommandMemory.id(activation, addressee.boat());
            if (!CommandMemory.isOver(activation, id, context)) {
                inputs.add(BoatDescriptions.remember(addressee.boat(), text.value()));
                inputs.addAll(CommandMemory.COMPLETED.remember(activation.mission(), id, context));
            }
        }
        if (!inputs.isEmpty()) {
            context.post(inputs);
        }
    }
}
