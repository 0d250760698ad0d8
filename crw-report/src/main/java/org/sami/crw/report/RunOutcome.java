package org.sami.crw.report;

import java.util.Locale;

/** How a run stands when it is reported, with the exit code that says so. */
public enum RunOutcome {
    /** The mission entered an end place, or was completed. */
    ENDED(0),
    ABORTED(3),
    /** The mission was halted (livelock), nothing could happen in it any longer, or the run itself broke. */
    FAILED(4),
    /** Stopped before the mission was over: by {@code --for} or by the user. */
    RUNNING(5);

    /** The exit code of a run that ended, with problems that no plan heard of. */
    public static final int PROBLEMS = 6;

    private final int exitCode;

    RunOutcome(int exitCode) {
        this.exitCode = exitCode;
    }

    /** The exit code of a command whose run came out like this. */
    public int exitCode() {
        return exitCode;
    }

    /** Whether the mission itself is over; otherwise it stands somewhere and waits for something. */
    public boolean isOver() {
        return this == ENDED || this == ABORTED;
    }

    /** The word in reports, such as {@code ended}. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
