package org.sami.spn.host;

import java.util.OptionalLong;

/** Tells when the time of the engine's next timer has come. It is armed by who holds the host's lock; the clock calls on a thread of its own. */
final class NextTimer {
    private final HostClock clock;
    private final Runnable reached;
    private volatile OptionalLong armedFor = OptionalLong.empty();

    /** No timer runs yet. */
    NextTimer(HostClock clock, Runnable reached) {
        this.clock = clock;
        this.reached = reached;
    }

    /**
     * From now on the next timer is this.
     *
     * @param dueMillis the session's time at which it ends; empty where none runs
     */
    void arm(OptionalLong dueMillis) {
        if (!dueMillis.equals(armedFor)) {
            armedFor = dueMillis;
            dueMillis.ifPresent(millis -> clock.wakeAt(millis, () -> timeReached(dueMillis)));
        }
    }

    /** A wake-up that was overtaken (its timer ended, an earlier one came) changes nothing. */
    private void timeReached(OptionalLong due) {
        if (due.equals(armedFor)) {
            armedFor = OptionalLong.empty();
            reached.run();
        }
    }
}
