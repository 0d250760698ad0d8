package org.sami.crw.sim.clock;

import java.util.Objects;
import java.util.Optional;
import java.util.PriorityQueue;
import org.sami.crw.session.Scheduler;

/**
 * The time of a run that is taken up: first that of its past, gone through again as fast as can be, and from {@link #goLive} on
 * that of another scheduler, which also gets what was still to come. For one thread.
 */
public final class CatchUpScheduler implements Scheduler {
    private final PriorityQueue<Entry> waiting = new PriorityQueue<>();
    private Optional<Scheduler> live = Optional.empty();
    private long nowMs;
    private long scheduled;

    @Override
    public long nowMs() {
        return live.map(Scheduler::nowMs).orElse(nowMs);
    }

    @Override
    public void at(long timeMs, Runnable action) {
        Objects.requireNonNull(action, "action");
        if (live.isPresent()) {
            live.get().at(timeMs, action);
        } else {
            waiting.add(new Entry(timeMs, scheduled++, action));
        }
    }

    /** Goes through the past up to a moment: what was due until then is done, each thing at its time. */
    public void advanceTo(long timeMs) {
        for (Entry next = waiting.peek(); next != null && next.timeMs <= timeMs; next = waiting.peek()) {
            waiting.remove();
            nowMs = Math.max(nowMs, next.timeMs);
            next.action.run();
        }
        nowMs = Math.max(nowMs, timeMs);
    }

    /** The past ends: from now on the time is another's. */
    public void goLive(Scheduler present) {
        live = Optional.of(present);
        for (Entry next = waiting.poll(); next != null; next = waiting.poll()) {
            present.at(next.timeMs, next.action);
        }
    }

    private record Entry(long timeMs, long order, Runnable action) implements Comparable<Entry> {
        @Override
        public int compareTo(Entry other) {
            int byTime = Long.compare(timeMs, other.timeMs);
            return byTime != 0 ? byTime : Long.compare(order, other.order);
        }
    }
}
