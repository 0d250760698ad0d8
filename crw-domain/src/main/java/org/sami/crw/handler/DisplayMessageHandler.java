package org.sami.crw.handler;

import org.sami.crw.handler.activation.ActivationFields;
import org.sami.crw.manipulation.ManipulationLimit;
import org.sami.crw.markup.MapRelevance;
import org.sami.crw.markup.MarkupReader;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.TextValue;

/**
 * Display Message: a message to the operator about the boats that entered, with its markups Priority and Keyword, and those that say what of
 * the map it is about (6.3.4). A base that goes on with the mission does not show it again.
 */
final class DisplayMessageHandler implements ActivationHandler {
    static final String TYPE = "DisplayMessage";

    private final MessageSink messages;

    DisplayMessageHandler(MessageSink messages) {
        this.messages = messages;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        if (ShownMessages.wasShown(activation, context)) {
            return;
        }
        if (!(ActivationFields.required(activation, "message") instanceof TextValue text)) {
            throw new IllegalArgumentException("\"message\" is no text: " + activation.value("message"));
        }
        MarkupReader markups = new MarkupReader(activation.markups());
        messages.tell(new OperatorMessage(
                        context.nowMillis(),
                        activation.mission(),
                        OperatorMessage.Source.PLAN,
                        activation.priority(),
                        text.value(),
                        activation.proxies(),
                        markups.text("Keyword", "source"),
                        MapRelevance.of(markups, activation.proxies(), context.query(EngineView::proxies)))
                .limited(activation.plan() + " " + activation.event(), ManipulationLimit.of(markups)));
        ShownMessages.remember(activation, context);
    }
}
