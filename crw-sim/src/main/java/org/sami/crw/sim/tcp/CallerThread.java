package org.sami.crw.sim.tcp;

import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/** The thread that waits for a run: shows what the run's threads want shown, and keeps an interrupt until the run is over. */
final class CallerThread {
    private final Consumer<String> lines;
    private final Queue<String> toShow = new ConcurrentLinkedQueue<>();
    private boolean interrupted;

    /** @param lines gets what is shown, on this thread */
    CallerThread(Consumer<String> lines) {
        this.lines = lines;
    }

    /** Has a line shown soon. From any thread. */
    void later(String line) {
        toShow.add(line);
    }

    /** Shows what waits. */
    void show() {
        for (String line = toShow.poll(); line != null; line = toShow.poll()) {
            lines.accept(line);
        }
    }

    /** Somebody wants an end. */
    void interrupted() {
        interrupted = true;
    }

    /** Waits for an end, for so many milliseconds at most; returns early when interrupted. */
    boolean await(CountDownLatch end, long millis) {
        try {
            return end.await(millis, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            interrupted = true;
            return false;
        }
    }

    /** The run is over: its caller gets the interrupt. */
    void restoreInterrupt() {
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
