package org.sami.crw.handler.activation;

import java.util.List;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;

/**
 * Optional answers: events with the flag {@code answer-optional}. Without a transition that waits for them they are not sent, so that the operator
 * sees no note about each.
 */
public final class OptionalAnswer {
    private OptionalAnswer() {}

    /** The answer as an input; none where no transition waits for answers of its type. */
    public static List<Input> of(Occurrence answer, HandlerContext context) {
        return context.query(view -> view.awaits(answer.type())) ? List.of(new Input.Received(answer)) : List.of();
    }
}
