package org.sami.crw.sim.clock;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
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
    private final PriorityQueue<Moment> moments = new PriorityQueue<>();
    private final Map<Long, Moment> byTime = new HashMap<>(); // the same ones
    // for which something was scheduled last: mostly the next action is for it as well
    private Optional<Moment> latest = Optional.empty();
    private long nowMs;
    private int pending;

    /** A time for which something waits: messages of a whole fleet mostly arrive together. */
    private record Moment(long timeMs, Deque<Runnable> actions) implements Comparable<Moment> {
        Moment(long timeMs) {
            this(timeMs, new ArrayDeque<>());
        }

        @Override
        public int compareTo(Moment other) {
            return Long.compare(timeMs, other.timeMs);
        }
    }

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
        moment(timeMs).actions.add(action);
        pending++;
    }

    private Moment moment(long timeMs) {
        if (latest.isEmpty() || latest.get().timeMs != timeMs) {
            latest = Optional.of(byTime.computeIfAbsent(timeMs, this::begin));
        }
        return latest.get();
    }

    private Moment begin(long timeMs) {
        Moment moment = new Moment(timeMs);
        moments.add(moment);
        return moment;
    }

    /** How many actions are waiting. */
    public int pending() {
        return pending;
    }

    /** When the next action runs, or empty if none waits. */
    public OptionalLong nextTimeMs() {
        Moment next = moments.peek();
        return next == null ? OptionalLong.empty() : OptionalLong.of(next.timeMs);
    }

    /**
     * Moves time to the next action and runs it.
     *
     * @return whether there was one
     */
    public boolean runNext() {
        Moment next = moments.peek();
        if (next == null) {
            return false;
        }
        Runnable action = next.actions.remove();
        pending--;
        if (next.actions.isEmpty()) {
            moments.remove();
            byTime.remove(next.timeMs);
            if (latest.isPresent() && latest.get().timeMs == next.timeMs) {
                latest = Optional.empty();
            }
        }
        nowMs = next.timeMs;
        action.run();
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
        for (Moment next = moments.peek(); next != null && next.timeMs <= timeMs; next = moments.peek()) {
            runNext();
        }
        nowMs = timeMs;
    }
}
