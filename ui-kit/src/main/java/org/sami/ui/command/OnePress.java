package org.sami.ui.command;

/**
 * Takes presses that follow one another within half a second for one: a double click, and a key that is held and repeats, begin one thing. On the
 * event thread.
 */
public final class OnePress {
    private static final long MIN_INTERVAL_NANOS = 500_000_000L;

    private long lastNanos;
    private boolean pressed;

    /** There was none yet. */
    public OnePress() {}

    /** Whether a press that comes now is one of its own; it is remembered. */
    public boolean isOwn() {
        return isOwn(System.nanoTime());
    }

    boolean isOwn(long nowNanos) {
        boolean own = !pressed || nowNanos - lastNanos > MIN_INTERVAL_NANOS;
        pressed = true;
        lastNanos = nowNanos; // a held key goes on repeating
        return own;
    }
}
