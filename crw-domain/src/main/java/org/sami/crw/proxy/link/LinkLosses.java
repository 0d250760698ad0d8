package org.sami.crw.proxy.link;

import java.util.ArrayDeque;
import java.util.Deque;

/** How often the link to one boat was lost lately, and whether it is lost now. For one thread, with milliseconds of one clock. */
public final class LinkLosses {
    /** Losses are counted for this time. */
    public static final long WINDOW_MS = BaseDefaults.FLAPPING_WINDOW_MS;

    /** A link that was lost so often within the window flaps. */
    public static final int FLAPPING = BaseDefaults.FLAPPING_LOSSES;

    private final Deque<Long> losses = new ArrayDeque<>();
    private boolean lost;

    /** The link was lost. */
    public void lost(long nowMs) {
        if (!lost) {
            losses.addLast(nowMs);
        }
        lost = true;
    }

    /** The link stands again. */
    public void back() {
        lost = false;
    }

    /** Whether it is lost now. */
    public boolean isLost() {
        return lost;
    }

    /** How often it was lost within the window. */
    public int count(long nowMs) {
        while (!losses.isEmpty() && nowMs - losses.peekFirst() > WINDOW_MS) {
            losses.removeFirst();
        }
        return losses.size();
    }

    /** Whether it is lost again and again. */
    public boolean flaps(long nowMs) {
        return count(nowMs) >= FLAPPING;
    }

    /** How often, and in what time, such as {@code 4 times in 2 min}. */
    public String words(long nowMs) {
        int count = count(nowMs);
        long seconds = count == 0 ? 0 : (nowMs - losses.peekFirst()) / 1000;
        String span = seconds < 60 ? Math.max(1, seconds) + " s" : Math.round(seconds / 60.0) + " min";
        return count == 1 ? "once in " + span : count + " times in " + span;
    }
}
