package org.sami.crw.operator.gantt;

import java.util.Objects;
import java.util.OptionalLong;

/**
 * A time during which something went on.
 *
 * @param label what went on
 * @param fromMillis its begin on the session's clock
 * @param beganBefore whether it began earlier, before this program followed the session
 * @param untilMillis its end, not before its begin; empty while it goes on
 */
public record GanttBar(String label, long fromMillis, boolean beganBefore, OptionalLong untilMillis) {
    public GanttBar {
        Objects.requireNonNull(label, "label");
        Objects.requireNonNull(untilMillis, "untilMillis");
    }

    /** Whether it goes on. */
    public boolean goesOn() {
        return untilMillis.isEmpty();
    }

    /** Its end, or the present moment while it goes on. */
    public long untilMillis(long nowMillis) {
        return untilMillis.orElse(Math.max(fromMillis, nowMillis));
    }
}
