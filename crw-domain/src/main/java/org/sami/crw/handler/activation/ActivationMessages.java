package org.sami.crw.handler.activation;

import java.util.List;
import org.sami.crw.message.OperatorMessage;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Priority;

/** What handlers tell the operator about an activation: as the domain, now, for its mission, replacing no earlier message. */
public final class ActivationMessages {
    private ActivationMessages() {}

    /**
     * A message about an activation.
     *
     * @param boats whom it is about; may be empty
     */
    public static OperatorMessage of(
            Activation activation, HandlerContext context, Priority priority, String text, List<String> boats) {
        return new OperatorMessage(
                context.nowMillis(), activation.mission(), OperatorMessage.Source.DOMAIN, priority, text, boats, "");
    }
}
