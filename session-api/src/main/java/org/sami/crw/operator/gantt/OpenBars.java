package org.sami.crw.operator.gantt;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.OptionalLong;

/** The bars of one row as time goes on; at most one of them is open. For one thread at a time. */
final class OpenBars {
    private static final int MOST = 300; // a row of a long day keeps its latest

    private final Deque<GanttBar> bars = new ArrayDeque<>();

    /** From now on this goes on; it continues the open bar where that says the same. */
    void show(String label, long atMillis, boolean beganBefore) {
        if (open() && bars.getLast().label().equals(label)) {
            return;
        }
        end(atMillis);
        add(new GanttBar(label, atMillis, beganBefore, OptionalLong.empty()));
    }

    /** Something happened that takes no time. Nothing else is open then. */
    void note(String label, long atMillis) {
        end(atMillis);
        add(new GanttBar(label, atMillis, false, OptionalLong.of(atMillis)));
    }

    /** Nothing goes on any longer. */
    void end(long atMillis) {
        if (open()) {
            GanttBar last = bars.removeLast();
            add(new GanttBar(
                    last.label(),
                    last.fromMillis(),
                    last.beganBefore(),
                    OptionalLong.of(Math.max(last.fromMillis(), atMillis))));
        }
    }

    private void add(GanttBar bar) {
        bars.addLast(bar);
        if (bars.size() > MOST) {
            bars.removeFirst();
        }
    }

    private boolean open() {
        return !bars.isEmpty() && bars.getLast().goesOn();
    }

    List<GanttBar> all() {
        return List.copyOf(bars);
    }
}
