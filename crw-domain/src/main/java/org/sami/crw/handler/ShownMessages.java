package org.sami.crw.handler;

import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.IntegerValue;

/**
 * Which messages of its plan a mission has shown, across restarts of the base: an activation is delivered again as long as its visit goes on. Activations
 * are numbered and handled in one order, so a mission remembers the newest alone. For the fleet's thread.
 */
final class ShownMessages {
    private static final String KEY = "shown";

    private ShownMessages() {}

    /** Whether it was shown before a restart of the base; not where somebody ordered it again. */
    static boolean wasShown(Activation activation, HandlerContext context) {
        return context.redelivered() && !context.orderedAgain() && activation.id() <= newest(activation, context);
    }

    /** Has the mission remember that it was shown; nothing where the mission is over, as nothing is delivered again then. */
    static void remember(Activation activation, HandlerContext context) {
        boolean goesOn =
                context.query(view -> view.mission(activation.mission()).isPresent());
        if (goesOn && activation.id() > newest(activation, context)) {
            context.post(new Input.Remember(activation.mission(), KEY, new IntegerValue(activation.id())));
        }
    }

    private static long newest(Activation activation, HandlerContext context) {
        return context.query(view -> view.memory(activation.mission(), KEY)
                .filter(IntegerValue.class::isInstance)
                .map(value -> ((IntegerValue) value).value())
                .orElse(0L));
    }
}
