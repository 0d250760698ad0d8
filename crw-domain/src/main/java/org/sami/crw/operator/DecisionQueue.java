package org.sami.crw.operator;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import org.sami.spn.host.ListenerList;
import org.sami.spn.host.Registration;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;

/**
 * Decisions that wait for the operator: the highest priority first, of equal ones the oldest first (thesis 5, markup Priority).
 * Owned by one thread.
 */
public final class DecisionQueue {
    private static final Comparator<PendingDecision> ORDER = Comparator.comparing(
                    (PendingDecision pending) -> pending.decision().priority())
            .reversed()
            .thenComparingLong(PendingDecision::openedAtMillis)
            .thenComparingLong(pending -> pending.decision().id());

    private final TreeSet<PendingDecision> ordered = new TreeSet<>(ORDER);
    private final Map<Long, PendingDecision> byId = new HashMap<>();
    private final ListenerList<DecisionListener> listeners = new ListenerList<>();

    /** Takes over what an effect says about decisions; others change nothing. */
    public void apply(Effect effect, long atMillis) {
        if (effect instanceof Effect.DecisionOpened opened) {
            open(opened.decision(), atMillis);
        } else if (effect instanceof Effect.DecisionClosed closed) {
            close(closed.decision(), closed.answer(), closed.by());
        }
    }

    /** Adds a decision; one that waits already stays as it is. */
    public void open(Decision decision, long atMillis) {
        PendingDecision pending = new PendingDecision(decision, atMillis);
        if (byId.putIfAbsent(decision.id(), pending) == null) {
            ordered.add(pending);
            listeners.each(listener -> listener.opened(pending));
        }
    }

    /** Takes a decision away; one that does not wait changes nothing. */
    public void close(long decision, Optional<Answer> answer, Optional<Answerer> by) {
        PendingDecision pending = byId.remove(decision);
        if (pending != null) {
            ordered.remove(pending);
            listeners.each(listener -> listener.closed(pending, answer, by));
        }
    }

    /** The decisions that wait now, in order. */
    public List<PendingDecision> pending() {
        return List.copyOf(ordered);
    }

    /** The decision of that id, if it waits. */
    public Optional<PendingDecision> find(long decision) {
        return Optional.ofNullable(byId.get(decision));
    }

    /** Adds a listener; closing the result takes it away. */
    public Registration addListener(DecisionListener listener) {
        return listeners.add(listener);
    }
}
