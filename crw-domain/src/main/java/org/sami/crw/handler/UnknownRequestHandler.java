package org.sami.crw.handler;

import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.TextValue;

/**
 * Unknown Request: an event of an imported plan that this system does not know. It is not silently nothing: the operator is
 * told each time a plan comes to it, though not again after a restart of the base, and what the plan waited for must be done by hand.
 */
final class UnknownRequestHandler implements ActivationHandler {
    static final String TYPE = "UnknownRequest";

    private final MessageSink messages;

    UnknownRequestHandler(MessageSink messages) {
        this.messages = messages;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        if (ShownMessages.wasShown(activation, context)) {
            return;
        }
        String name = ActivationFields.required(activation, "class") instanceof TextValue text ? text.value() : "";
        messages.tell(new OperatorMessage(
                context.nowMillis(),
                activation.mission(),
                OperatorMessage.Source.PLAN,
                activation.priority(),
                "The plan asks for " + name + ", which this system does not know; nothing is done",
                activation.proxies(),
                ""));
        ShownMessages.remember(activation, context);
    }
}
