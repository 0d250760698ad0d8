package org.sami.crw.decision;

import java.lang.System.Logger.Level;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;

/** The listeners of a model. One that throws is logged and does not keep the others from hearing. */
final class ListenerList<L> {
    private static final System.Logger LOG = System.getLogger(ListenerList.class.getName());

    private final List<L> listeners = new CopyOnWriteArrayList<>();

    /** Adds a listener; running the result takes it away. */
    Runnable add(L listener) {
        listeners.add(listener);
        return () -> listeners.remove(listener);
    }

    void tell(Consumer<L> news) {
        for (L listener : listeners) {
            try {
                news.accept(listener);
            } catch (RuntimeException fault) {
                LOG.log(Level.ERROR, "A listener failed: " + listener.getClass().getName(), fault);
            }
        }
    }
}
