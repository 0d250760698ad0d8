package org.sami.crw.operator;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.ToLongFunction;
import java.util.function.UnaryOperator;
import org.sami.crw.operator.decision.DecisionListener;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.spn.engine.DecisionCheck;
import org.sami.spn.host.ListenerList;
import org.sami.spn.host.Registration;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Decisions that wait for the operator: the highest priority first, of equal ones the oldest first (thesis 5, markup Priority).
 */
public final class DecisionQueue extends Model<List<PendingDecision>> {
    private final TreeSet<PendingDecision> ordered =
            new TreeSet<>(order(PendingDecision::decision, PendingDecision::openedAtMillis));
    private final Map<Long, PendingDecision> byId = new HashMap<>();
    private final ListenerList<DecisionListener> listeners = new ListenerList<>();
    private final Consumer<Runnable> inbox;

    /**
     * An empty queue.
     *
     * @param inbox brings changes to the owner's thread
     */
    DecisionQueue(Consumer<Runnable> inbox) {
        super(List.of());
        this.inbox = inbox;
    }

    /**
     * The order of the queue, for whoever holds decisions in another form.
     *
     * @param openedAtMillis when a decision was asked
     */
    public static <T> Comparator<T> order(Function<T, Decision> decision, ToLongFunction<T> openedAtMillis) {
        return Comparator.comparing((T one) -> decision.apply(one).priority())
                .reversed()
                .thenComparingLong(openedAtMillis)
                .thenComparingLong(one -> decision.apply(one).id());
    }

    /** Adds a decision; one that waits already stays as it is. */
    void open(PendingDecision pending) {
        if (byId.putIfAbsent(pending.decision().id(), pending) == null) {
            ordered.add(pending);
            change();
            listeners.each(listener -> listener.opened(pending));
        }
    }

    /** Takes a decision away; one that does not wait changes nothing. */
    void close(long decision, Optional<Answer> answer, Optional<Answerer> by) {
        PendingDecision pending = byId.remove(decision);
        if (pending != null) {
            ordered.remove(pending);
            change();
            listeners.each(listener -> listener.closed(pending, answer, by));
        }
    }

    /** Forgets all but those that wait as they did, telling nobody that one was answered. What was half entered for one that stays belongs to it still. */
    void retain(List<Decision> waiting) {
        byId.values().removeIf(pending -> !waiting.contains(pending.decision()));
        ordered.retainAll(byId.values());
        change();
    }

    /**
     * The operator turns to a decision: no attention is drawn to it any longer (markup Attention, end On Click). One that waits no longer
     * changes nothing. From any thread; done a little later.
     */
    public void attend(long decision) {
        inbox.accept(() -> replace(
                decision, pending -> new PendingDecision(pending.presentation(), pending.openedAtMillis(), true)));
    }

    private void replace(long decision, UnaryOperator<PendingDecision> with) {
        PendingDecision before = byId.get(decision);
        if (before != null) {
            ordered.remove(before);
            PendingDecision after = with.apply(before);
            ordered.add(after);
            byId.put(decision, after);
            change();
        }
    }

    /** The timer of a decision was stopped; one that does not wait changes nothing. */
    void hold(long decision) {
        replace(
                decision,
                pending -> new PendingDecision(
                        pending.presentation().withDecision(pending.decision().withoutDeadline()),
                        pending.openedAtMillis(),
                        pending.attended()));
        PendingDecision held = byId.get(decision);
        if (held != null) {
            listeners.each(listener -> listener.held(held));
        }
    }

    @Override
    List<PendingDecision> take() {
        return List.copyOf(ordered);
    }

    /** The decisions that wait now, in order. From any thread. */
    public List<PendingDecision> pending() {
        return snapshot();
    }

    /** The decision of that id, if it waits. From any thread. */
    public Optional<PendingDecision> find(long decision) {
        return snapshot().stream()
                .filter(pending -> pending.decision().id() == decision)
                .findFirst();
    }

    /**
     * Why an answer would be refused now, in one sentence; empty where it would be accepted. From any thread. A posted answer may still be too late,
     * if another operator answers first.
     */
    public Optional<String> check(long decision, Answer answer, Vocabulary vocabulary) {
        return find(decision)
                .map(pending -> DecisionCheck.wrong(pending.decision(), answer, vocabulary))
                .orElse(Optional.of("Decision " + decision + " waits no longer"));
    }

    /** Adds a listener to all decisions; closing the result takes it away. From any thread. */
    public Registration addListener(DecisionListener listener) {
        return listeners.add(listener);
    }
}
