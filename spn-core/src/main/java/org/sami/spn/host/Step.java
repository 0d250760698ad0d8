package org.sami.spn.host;

import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;

/**
 * One input and what followed from it, kept back until its batch is durable.
 *
 * @param activations those among the effects, in order: when a large batch leaves, its effects are in no cache of the processor any more
 */
record Step(JournalEntry entry, List<Effect> effects, List<Activation> activations, InputReply reply) {
    private static final System.Logger LOG = System.getLogger(Step.class.getName());

    /** One input with all that followed from it. */
    static Step of(JournalEntry entry, List<Effect> effects, InputReply reply) {
        return new Step(entry, Collections.unmodifiableList(effects), activations(effects), reply);
    }

    private static List<Activation> activations(List<Effect> effects) {
        List<Activation> found = List.of();
        for (Effect effect : effects) {
            if (effect instanceof Effect.Activated activated) {
                found = found.isEmpty() ? new ArrayList<>(1) : found;
                found.add(activated.activation());
            }
        }
        return found;
    }

    /** Publishes the step: first to whoever posted the input, then to the listeners, then to the handlers of its activations. */
    void letOut(ListenerList<HostListener> listeners, Handlers handlers, EngineView view) {
        callReply();
        if (!listeners.isEmpty()) {
            listeners.each(listener -> listener.onStep(entry.index(), entry.atMillis(), entry.input(), effects, view));
        }
        for (Activation activation : activations) {
            handlers.deliver(activation, Handlers.Delivery.FIRST);
        }
    }

    private void callReply() {
        try {
            reply.onProcessed(effects);
        } catch (RuntimeException | LinkageError | StackOverflowError | AssertionError fault) {
            LOG.log(Level.ERROR, () -> "whoever waited for entry " + entry.index() + " threw and was ignored", fault);
        }
    }
}
