package org.sami.crw.sim.clock;

import java.util.Objects;
import java.util.OptionalLong;
import java.util.PriorityQueue;

/**
 * The deterministic scheduler of the simulated world: actions run by time, then by the order in which they were
 * scheduled. Equal schedules give equal runs at any speed.
 *
 * <p>Whoever owns the clock drives it with {@link #runNext} or {@link #runUntil}, from one thread. What an action throws
 * reaches the driver; the action is then used up, and time and the other actions are as if it had returned.
 */
public final class VirtualClock implements VirtualScheduler {
    private final PriorityQueue<Entry> waiting = new PriorityQueue<>();
    private long nowMs;
    private long scheduled;

    /** A clock at time zero with nothing to do. */
    public VirtualClock() {
        this(0);
    }

    /** A clock that starts at a given time, for a world that goes on. */
    public VirtualClock(long startMs) {
        nowMs = startMs;
    }

    @Override
    public long nowMs() {
        return nowMs;
    }

    @Override
    public void at(long timeMs, Runnable action) {
        Objects.requireNonNull(action, "action");
        if (timeMs < nowMs) {
            throw new IllegalArgumentException(
                    "it is " + nowMs + " ms: nothing can be scheduled for " + timeMs + " ms");
        }
        waiting.add(new Entry(timeMs, scheduled++, action));
    }

    /** How many actions are waiting. */
    public int pending() {
        return waiting.size();
    }

    /** When the next action runs, or empty if none waits. */
    public OptionalLong nextTimeMs() {
        Entry next = waiting.peek();
        return next == null ? OptionalLong.empty() : OptionalLong.of(next.timeMs);
    }

    /**
     * Moves time to the next action and runs it.
     *
     * @return whether there was one
     */
    public boolean runNext() {
        Entry next = waiting.poll();
        if (next == null) {
            return false;
        }
        nowMs = next.timeMs;
        next.action.run();
        return true;
    }

    /**
     * Runs every action up to and including a moment, those that are scheduled meanwhile too, and leaves the clock at
     * that moment.
     *
     * @throws IllegalArgumentException if the moment lies in the past
     */
    public void runUntil(long timeMs) {
        if (timeMs < nowMs) {
            throw new IllegalArgumentException("it is " + nowMs + " ms: time does not run back to " + timeMs + " ms");
        }
        for (Entry next = waiting.peek(); next != null && next.timeMs <= timeMs; next = waiting.peek()) {
            runNext();
        }
        nowMs = timeMs;
    }

    private record Entry(long timeMs, long order, Runnable action) implements Comparable<Entry> {

        @Override
        public int compareTo(Entry other) {
            int byTime = Long.compare(timeMs, other.timeMs);
            return byTime != 0 ? byTime : Long.compare(order, other.order);
        }
    }
}
