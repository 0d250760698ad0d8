package org.sami.crw.gui.decision;

import java.util.List;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.sami.crw.operator.decision.PendingDecision;

/**
 * Which decision is shown in full: the most urgent one, unless the operator browses or has begun to answer. What is shown is never
 * replaced while the pointer is down, nor for {@link #REST_MILLIS} after, so that no finger hits what was not there when it set out. For one
 * thread; knows no window.
 */
final class ShownDecision {
    /** How long after the pointer was lifted nothing is replaced. */
    static final long REST_MILLIS = 300;

    private final LongSupplier nowMillis;
    private List<PendingDecision> queue = List.of();
    private Optional<PendingDecision> shown = Optional.empty();
    private boolean kept;
    private boolean pointerDown;
    private long restUntilMillis;

    /**
     * Nothing is shown.
     *
     * @param nowMillis a clock that never goes back
     */
    ShownDecision(LongSupplier nowMillis) {
        this.nowMillis = nowMillis;
    }

    /** What waits now, the most urgent first. */
    void queue(List<PendingDecision> pending) {
        queue = List.copyOf(pending);
        shown = shown.map(one -> find(one.decision().id()).orElse(one));
        settle();
    }

    /** The pointer went down on the panel. */
    void pointerDown() {
        pointerDown = true;
    }

    /** The pointer was lifted. */
    void pointerUp() {
        pointerDown = false;
        restUntilMillis = nowMillis.getAsLong() + REST_MILLIS;
    }

    /** Whether nothing may be replaced now. */
    boolean rests() {
        return pointerDown || nowMillis.getAsLong() < restUntilMillis;
    }

    /** The operator works on what is shown: it stays although more urgent ones come. */
    void keep() {
        kept = shown.isPresent();
    }

    /** The operator is done with what is shown: the most urgent one is shown again, as soon as that may be. */
    void follow() {
        kept = false;
        settle();
    }

    /** Shows one that the operator chose; one that does not wait changes nothing. */
    void select(long decision) {
        find(decision).ifPresent(one -> {
            shown = Optional.of(one);
            kept = true;
        });
    }

    /** Shows the one that waits behind the shown one, or before it; after the last comes the first. Answers nothing. */
    void browse(int step) {
        if (!queue.isEmpty()) {
            int next = position() < 0 ? 0 : Math.floorMod(position() + step, queue.size());
            select(queue.get(next).decision().id());
        }
    }

    /** Replaces what is shown where it is to be replaced, and nothing forbids it now. Asked again after {@link #REST_MILLIS}. */
    boolean settle() {
        boolean stays = shown.isPresent() && !isOver() && kept;
        if (stays || (rests() && shown.isPresent())) {
            return false;
        }
        Optional<PendingDecision> next = queue.stream().findFirst();
        boolean other = !next.map(one -> one.decision().id())
                .equals(shown.map(one -> one.decision().id()));
        shown = next;
        if (other) {
            kept = false;
        }
        return other;
    }

    /** What waits first, whether it is shown or not. */
    Optional<PendingDecision> mostUrgent() {
        return queue.stream().findFirst();
    }

    /** What is shown; it may wait no longer while nothing may be replaced. */
    Optional<PendingDecision> shown() {
        return shown;
    }

    /** Whether what is shown waits no longer. */
    boolean isOver() {
        return shown.isPresent() && position() < 0;
    }

    /** Where the shown one stands in the queue, from 0; -1 where it does not. */
    int position() {
        for (int i = 0; i < queue.size(); i++) {
            if (shown.isPresent()
                    && queue.get(i).decision().id() == shown.get().decision().id()) {
                return i;
            }
        }
        return -1;
    }

    /** Those that wait, the most urgent first. */
    List<PendingDecision> queue() {
        return queue;
    }

    /** How many wait. */
    int waiting() {
        return queue.size();
    }

    private Optional<PendingDecision> find(long decision) {
        return queue.stream().filter(one -> one.decision().id() == decision).findFirst();
    }
}
