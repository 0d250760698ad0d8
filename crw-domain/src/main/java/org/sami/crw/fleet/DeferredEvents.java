package org.sami.crw.fleet;

import java.util.ArrayDeque;
import java.util.function.Consumer;
import org.sami.spn.host.ListenerList;

/**
 * Events of a proxy, deferred until it has finished a change, in order. A listener that calls back finds the proxy consistent, and
 * events that this causes come after the present ones. What the listener throws is logged and does not keep the proxy from its work.
 */
public final class DeferredEvents {
    private final ListenerList<Consumer<? super FleetEvent>> listener = new ListenerList<>();
    private final ArrayDeque<FleetEvent> waiting = new ArrayDeque<>();
    private boolean delivering;

    /** No event is waiting. */
    public DeferredEvents(Consumer<? super FleetEvent> listener) {
        this.listener.add(listener);
    }

    /** Keeps an event for the listener. */
    public void add(FleetEvent event) {
        waiting.add(event);
    }

    /** Gives the listener what was kept, in its order. */
    public void deliver() {
        if (delivering) {
            return;
        }
        delivering = true;
        try {
            for (FleetEvent next = waiting.poll(); next != null; next = waiting.poll()) {
                FleetEvent event = next;
                listener.each(one -> one.accept(event));
            }
        } finally {
            delivering = false;
        }
    }
}
