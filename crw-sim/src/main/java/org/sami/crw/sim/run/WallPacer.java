package org.sami.crw.sim.run;

import java.util.concurrent.locks.LockSupport;
import org.sami.crw.sim.run.settings.Speed;

/** Paces against the machine's monotonic clock, and catches up with time that a slow machine lost. */
public final class WallPacer implements Pacer {
    /** Shorter waits are skipped; the next one includes them. */
    private static final long LEAST_WAIT_NANOS = 1_000_000;

    private static final long LONGEST_WAIT_NANOS = 100_000_000;

    private final Speed speed;
    private long wallStart;
    private long virtualStart;

    private WallPacer(Speed speed) {
        this.speed = speed;
        this.wallStart = System.nanoTime();
    }

    /** The pacer of a speed, on the machine's monotonic clock; one that never waits where the speed has no limit. */
    public static Pacer of(Speed speed) {
        return speed.isMax() ? UNPACED : new WallPacer(speed);
    }

    @Override
    public void start(long virtualMillis) {
        wallStart = System.nanoTime();
        virtualStart = virtualMillis;
    }

    @Override
    public void awaitTurn(long virtualMillis) {
        long due = wallStart + (long) ((virtualMillis - virtualStart) * 1e6 / speed.factor());
        long left = due - System.nanoTime();
        while (left >= LEAST_WAIT_NANOS && !Thread.currentThread().isInterrupted()) {
            LockSupport.parkNanos(Math.min(left, LONGEST_WAIT_NANOS));
            left = due - System.nanoTime();
        }
    }
}
