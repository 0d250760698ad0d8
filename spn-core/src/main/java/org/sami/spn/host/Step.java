package org.sami.spn.host;

import java.util.List;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Effect;

/** One input and what followed from it, kept back until its batch is durable. */
record Step(JournalEntry entry, List<Effect> effects) {
    /** Tells first the listeners, then the handlers of its activations. */
    void letOut(ListenerList<HostListener> listeners, Handlers handlers, EngineView view) {
        if (!listeners.isEmpty()) {
            listeners.each(listener -> listener.onStep(entry.index(), entry.atMillis(), entry.input(), effects, view));
        }
        for (Effect effect : effects) {
            if (effect instanceof Effect.Activated activated) {
                handlers.deliver(activated.activation(), false);
            }
        }
    }
}
