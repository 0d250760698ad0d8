package org.sami.ui.look;

/** The scale of all windows, as {@link Look} has put it in force. From any thread. */
final class LookScale {
    /** The smallest scale, in percent. */
    static final int LEAST = 80;

    /** The largest scale, in percent. */
    static final int MOST = 200;

    private static volatile int percent = 100;

    private LookScale() {}

    /** The scale in force, in percent. */
    static int percent() {
        return percent;
    }

    /** Puts a scale in force; what lies outside is brought to the nearer end. */
    static void put(int scale) {
        percent = Math.min(MOST, Math.max(LEAST, scale));
    }
}
