package org.sami.spn.host;

import java.lang.System.Logger.Level;
import java.util.List;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Effect;

/** One input and what followed from it, kept back until its batch is durable. */
record Step(JournalEntry entry, List<Effect> effects, InputReply reply) {
    private static final System.Logger LOG = System.getLogger(Step.class.getName());

    /** Publishes the step: first to whoever posted the input, then to the listeners, then to the handlers of its activations. */
    void letOut(ListenerList<HostListener> listeners, Handlers handlers, EngineView view) {
        callReply();
        if (!listeners.isEmpty()) {
            listeners.each(listener -> listener.onStep(entry.index(), entry.atMillis(), entry.input(), effects, view));
        }
        for (Effect effect : effects) {
            if (effect instanceof Effect.Activated activated) {
                handlers.deliver(activated.activation(), false);
            }
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
