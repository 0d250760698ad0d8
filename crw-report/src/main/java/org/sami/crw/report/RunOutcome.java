package org.sami.crw.report;

import java.util.Locale;

/** How a run stands when it is reported. */
public enum RunOutcome {
    /** The mission entered an end place, or was completed. */
    ENDED,
    ABORTED,
    /** The mission was halted (livelock), nothing could happen in it any longer, or the run itself broke. */
    FAILED,
    /** Stopped before the mission was over: by {@code --for} or by the user. */
    RUNNING;

    /** Whether the mission itself is over; otherwise it stands somewhere and waits for something. */
    public boolean isOver() {
        return this == ENDED || this == ABORTED;
    }

    /** The word in reports, such as {@code ended}. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
