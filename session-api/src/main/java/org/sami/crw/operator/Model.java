package org.sami.crw.operator;

import java.util.Objects;
import java.util.function.Consumer;
import org.sami.spn.host.ListenerList;
import org.sami.spn.host.Registration;

/**
 * Something that lies before the operator, as an immutable snapshot that is replaced when it changes.
 *
 * <p>The state behind it belongs to the owner's thread. The snapshot may be read from any thread, at once. Listeners are called on the
 * owner's thread, after the snapshot was replaced; several changes that came together are published as one.
 *
 * @param <S> type of the snapshot; immutable
 */
public abstract class Model<S> {
    private final ListenerList<Consumer<? super S>> listeners = new ListenerList<>();
    private volatile S snapshot;
    private boolean changed; // for the owner's thread
    private boolean takenWhenAsked; // then only that thread asks

    Model(S empty) {
        snapshot = Objects.requireNonNull(empty, "empty");
    }

    /** What lies before the operator now. From any thread. */
    public final S snapshot() {
        if (takenWhenAsked && changed) {
            replace();
        }
        return snapshot;
    }

    /**
     * From now on a snapshot without listeners is made only on request. For models that only their owner's thread reads; to be called before the
     * first read.
     */
    final void takeWhenAsked() {
        takenWhenAsked = true;
    }

    /** Adds a listener, which is given each new snapshot on the owner's thread; closing the result takes it away. From any thread. */
    public final Registration addListener(Consumer<? super S> listener) {
        return listeners.add(listener);
    }

    /** Makes a snapshot of the state; on the owner's thread. */
    abstract S take();

    /** The state has changed, or may have. */
    final void change() {
        changed = true;
    }

    /** Replaces the snapshot where the state has changed, and tells the listeners. */
    final void publish() {
        if (changed && !(takenWhenAsked && listeners.isEmpty())) {
            replace();
        }
    }

    private void replace() {
        changed = false;
        S next = take();
        if (!next.equals(snapshot)) {
            snapshot = next;
            listeners.each(listener -> listener.accept(next));
        }
    }
}
