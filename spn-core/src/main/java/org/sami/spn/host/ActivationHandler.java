package org.sami.spn.host;

import org.sami.spn.protocol.Activation;

/**
 * Does what the output events of one type ask. Called on the executor that it was registered with, never on the engine's
 * thread unless that is what was registered.
 */
@FunctionalInterface
public interface ActivationHandler {
    /**
     * Handles one activation. Answers are posted through the context, now or later, from any thread. Must be idempotent
     * by the activation's id: after a crash an open activation is delivered again.
     *
     * @throws Exception where it cannot: becomes an input {@code HandlerFailed} with the exception's message
     */
    void handle(Activation activation, HandlerContext context) throws Exception;
}
