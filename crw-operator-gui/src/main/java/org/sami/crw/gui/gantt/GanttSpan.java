package org.sami.crw.gui.gantt;

import java.util.List;
import java.util.OptionalLong;

/** How much time the chart shows: all of the missions that run, or the last minutes. On the event thread. */
final class GanttSpan {
    private static final List<Long> MINUTES = List.of(2L, 5L, 10L, 30L, 60L, 240L);
    private static final long MINUTE_MS = 60_000;
    private static final long LEAST_MS = 30_000;
    private static final double AHEAD = 0.06; // of the width, so that what goes on is seen to

    private int step = MINUTES.size(); // all

    /** Shows less time, or more; whether that changed anything. */
    boolean zoom(boolean in) {
        int next = Math.max(0, Math.min(MINUTES.size(), step + (in ? -1 : 1)));
        boolean other = next != step;
        step = next;
        return other;
    }

    /** Shows all of the missions that run. */
    void all() {
        step = MINUTES.size();
    }

    /** What is shown, in words. */
    String words() {
        return step == MINUTES.size() ? "all of it" : "the last " + MINUTES.get(step) + " min";
    }

    /**
     * The axis now.
     *
     * @param start of the earliest mission; empty where there is none
     * @param end of the last one, where none runs
     */
    GanttAxis axis(OptionalLong start, OptionalLong end, long nowMillis, double widthPx) {
        long last = Math.min(nowMillis, end.orElse(nowMillis));
        long first = step == MINUTES.size() ? Math.min(start.orElse(last), last) : last - MINUTES.get(step) * MINUTE_MS;
        long span = Math.max(LEAST_MS, last - first);
        return new GanttAxis(first, first + Math.round(span / (1 - AHEAD)), Math.max(1, widthPx));
    }
}
