package org.sami.boat.app.screen;

/**
 * The lock against presses by mistake: in a closed box, by drops, by a pocket. Locked, a button does nothing, except the stop, which has to be held. It locks by
 * itself when nobody has touched the screen for a while. For one thread.
 */
final class ScreenLock {
    /** It locks after this time in ms without a touch. */
    static final long AFTER_MS = 60_000;

    private boolean locked = true;
    private long touchedMs;

    /** Whether buttons do nothing at a time. */
    boolean isLocked(long nowMs) {
        locked = locked || nowMs - touchedMs >= AFTER_MS;
        return locked;
    }

    /** Somebody has held the lock. */
    void unlock(long nowMs) {
        locked = false;
        touchedMs = nowMs;
    }

    /** Locks now. */
    void lock() {
        locked = true;
    }

    /** Somebody touches the screen. */
    void touched(long nowMs) {
        if (!isLocked(nowMs)) {
            touchedMs = nowMs;
        }
    }
}
