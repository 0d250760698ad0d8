package org.sami.ui.check;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/**
 * Counts the events of pointer and keys that come to the event thread, so that a robot goes on as soon as what it did is handled.
 * {@link java.awt.Robot#waitForIdle} waits until the whole window is idle, which one with moving boats never is: up to ten seconds for a
 * click.
 */
final class HandledInput {
    private static final HandledInput INSTANCE = new HandledInput();

    private final Map<Integer, Long> counts = new HashMap<>();

    private HandledInput() {
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(new EventQueue() {
            @Override
            protected void dispatchEvent(AWTEvent event) {
                if (event instanceof InputEvent) {
                    count(event.getID()); // before it is handled: what it opens may run a loop of its own until it
                    // is closed
                }
                super.dispatchEvent(event);
            }
        });
    }

    /** The counter of this process. */
    static HandledInput instance() {
        return INSTANCE;
    }

    private synchronized void count(int id) {
        counts.merge(id, 1L, Long::sum);
        notifyAll();
    }

    /** How many events of a kind have come. */
    synchronized long counted(int id) {
        return counts.getOrDefault(id, 0L);
    }

    /**
     * Waits until so many events of a kind have come.
     *
     * @param id as {@link AWTEvent#getID} gives it
     * @return whether they came within the time
     */
    synchronized boolean await(int id, long many, long millis) {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
        while (counted(id) < many) {
            long left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
            if (left <= 0) {
                return false;
            }
            try {
                wait(left);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                return false;
            }
        }
        return true;
    }
}
