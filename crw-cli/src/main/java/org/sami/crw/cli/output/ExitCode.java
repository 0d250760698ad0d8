package org.sami.crw.cli.output;

import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;

/** The exit codes of the command, the same for every subcommand. */
public final class ExitCode {
    /** It was done; a mission ended. */
    public static final int OK = 0;

    /** A plan or a file has errors. */
    public static final int FINDINGS = 1;

    /** The command line makes no sense, or a file that it names cannot be read. */
    public static final int USAGE = 2;

    /** The mission was aborted. */
    public static final int ABORTED = 3;

    /** Something broke, or the mission failed. */
    public static final int FAILED = 4;

    /** The run stopped before its mission was over. */
    public static final int RUNNING = 5;

    /** The mission ended, with problems that no plan heard of. */
    public static final int PROBLEMS = 6;

    private ExitCode() {}

    /** The exit code of a command whose run came out like this and had no problems. */
    public static int of(RunOutcome outcome) {
        return switch (outcome) {
            case ENDED -> OK;
            case ABORTED -> ABORTED;
            case FAILED -> FAILED;
            case RUNNING -> RUNNING;
        };
    }

    /** The exit code of a command that ran what a report is of. */
    public static int of(RunReport report) {
        RunOutcome outcome = report.result().outcome();
        return outcome == RunOutcome.ENDED && !report.isGreen() ? PROBLEMS : of(outcome);
    }
}
