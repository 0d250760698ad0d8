package org.sami.crw.proxy.listener;

import java.util.ArrayDeque;
import java.util.function.Consumer;

/**
 * Notifications of the listener, deferred until the proxy has finished a change, in order. A listener that calls back finds the proxy consistent, and
 * notifications that this causes come after the present ones.
 */
public final class DeferredNotifications {
    private final BoatListener listener;
    private final ArrayDeque<Consumer<BoatListener>> waiting = new ArrayDeque<>();
    private boolean speaking;

    /** No notification is waiting. */
    public DeferredNotifications(BoatListener listener) {
        this.listener = new BoatListeners(listener); // what it throws must not keep the proxy from its work
    }

    /** Keeps news for the listener. */
    public void add(Consumer<BoatListener> announcement) {
        waiting.add(announcement);
    }

    /** Tells the listener what was kept, in its order. */
    public void deliver() {
        if (speaking || waiting.isEmpty()) {
            return;
        }
        speaking = true;
        try {
            for (var next = waiting.poll(); next != null; next = waiting.poll()) {
                next.accept(listener);
            }
        } finally {
            speaking = false;
        }
    }
}
