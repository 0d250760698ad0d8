package org.sami.crw.gui.decision;

import java.util.function.LongSupplier;
import org.sami.ui.EventThread;

/**
 * Tells a press that was made before a question could be read from one that is meant for it. A busy window handles presses late: the second of two quick ones may
 * come to a question that nobody has seen. A question that comes by itself cannot be meant by a finger that is on its way already. On the event thread.
 */
final class PressTimes {
    /** How long a question that came by itself is shown before a press may answer it. */
    static final long READ_MS = 500;

    private static final long CLOCK_SET_MS =
            10_000; // no window is busy for so long; a clock that was set back makes every press look early

    private final LongSupplier wallMillis;
    private long shownMillis = Long.MIN_VALUE;
    private long readMillis = Long.MIN_VALUE;

    /**
     * No question is shown.
     *
     * @param wallMillis the clock by which the display gives presses their times
     */
    PressTimes(LongSupplier wallMillis) {
        this.wallMillis = wallMillis;
    }

    /**
     * Another question is shown now.
     *
     * @param byItself false = the operator turned to it, and knows that another one comes
     */
    void turned(boolean byItself) {
        shownMillis = wallMillis.getAsLong();
        readMillis = byItself ? shownMillis + READ_MS : shownMillis;
    }

    /** Whether a press was made before the question was shown that is shown now. */
    boolean isEarlier(long pressedMillis) {
        return pressedMillis < shownMillis && isOfThisClock(pressedMillis);
    }

    /** Whether a press was made before the question that is shown now could be read. */
    boolean isUnread(long pressedMillis) {
        return pressedMillis < readMillis && isOfThisClock(pressedMillis);
    }

    private boolean isOfThisClock(long pressedMillis) {
        return pressedMillis > shownMillis - CLOCK_SET_MS;
    }

    /** Whether what the event thread handles now is a press that was made before the question was shown; what a program does is none. */
    boolean isHandledLate() {
        return EventThread.handledInput()
                .filter(press -> isEarlier(press.getWhen()))
                .isPresent();
    }

    /** Whether what the event thread handles now is a press that was made before the question could be read; what a program does is none. */
    boolean isHandledUnread() {
        return EventThread.handledInput()
                .filter(press -> isUnread(press.getWhen()))
                .isPresent();
    }
}
