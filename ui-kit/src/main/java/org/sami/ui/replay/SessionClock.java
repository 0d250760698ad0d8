package org.sami.ui.replay;

import java.util.Locale;

/** Moments of a session as clocks show them: hours, minutes and seconds since its start. */
public final class SessionClock {
    private SessionClock() {}

    /** A moment, in ms since the session's start. */
    public static String text(long millis) {
        long seconds = Math.max(0, millis) / 1000;
        return String.format(Locale.ROOT, "%d:%02d:%02d", seconds / 3600, seconds / 60 % 60, seconds % 60);
    }
}
