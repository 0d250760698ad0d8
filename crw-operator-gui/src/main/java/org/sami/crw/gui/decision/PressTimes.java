package org.sami.crw.gui.decision;

import java.util.function.LongSupplier;
import org.sami.ui.EventThread;

/**
 * Tells a press that was made before a question was shown from one that is meant for it. A busy window handles presses late: the second of two quick ones may
 * come to a question that nobody has seen. On the event thread.
 */
final class PressTimes {
    private static final long CLOCK_SET_MS =
            10_000; // no window is busy for so long; a clock that was set back makes every press look early

    private final LongSupplier wallMillis;
    private long shownMillis = Long.MIN_VALUE;

    /**
     * No question is shown.
     *
     * @param wallMillis the clock by which the display gives presses their times
     */
    PressTimes(LongSupplier wallMillis) {
        this.wallMillis = wallMillis;
    }

    /** Another question is shown now. */
    void turned() {
        shownMillis = wallMillis.getAsLong();
    }

    /** Whether a press was made before the question was shown that is shown now. */
    boolean isEarlier(long pressedMillis) {
        return pressedMillis < shownMillis && pressedMillis > shownMillis - CLOCK_SET_MS;
    }

    /** Whether what the event thread handles now is a press that was made before the question was shown; what a program does is none. */
    boolean isHandledLate() {
        return EventThread.handledInput()
                .filter(press -> isEarlier(press.getWhen()))
                .isPresent();
    }
}
