package org.sami.crw.gui.gantt;

import java.util.ArrayList;
import java.util.List;

/**
 * The axis of time: which moments are in sight, and where.
 *
 * @param fromMillis the first, on the session's clock
 * @param untilMillis the last, after the first
 * @param widthPx on which they lie
 */
record GanttAxis(long fromMillis, long untilMillis, double widthPx) {
    private static final long[] STEPS_S = {
        1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14_400, 43_200, 86_400
    };

    GanttAxis {
        if (untilMillis <= fromMillis) {
            throw new IllegalArgumentException("an axis from " + fromMillis + " ms to " + untilMillis + " ms");
        }
    }

    /** Where a moment lies, in pixels from the left; outside the width where it is not in sight. */
    double x(long millis) {
        return (millis - fromMillis) * widthPx / (untilMillis - fromMillis);
    }

    /** The moment at a place, in ms. */
    long millis(double x) {
        return fromMillis + Math.round(x * (untilMillis - fromMillis) / widthPx);
    }

    /** Round moments in sight, at least so many pixels apart. */
    List<Long> ticks(double leastPx) {
        long step = STEPS_S[STEPS_S.length - 1] * 1000;
        for (int i = STEPS_S.length - 1; i >= 0; i--) {
            long shorter = STEPS_S[i] * 1000;
            if (shorter * widthPx / (untilMillis - fromMillis) >= leastPx) {
                step = shorter;
            }
        }
        List<Long> ticks = new ArrayList<>();
        for (long at = Math.floorDiv(fromMillis + step - 1, step) * step; at <= untilMillis; at += step) {
            ticks.add(at);
        }
        return ticks;
    }
}
