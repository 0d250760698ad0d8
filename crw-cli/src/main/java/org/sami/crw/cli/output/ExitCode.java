package org.sami.crw.cli.output;

/** The exit codes of the command, the same for every subcommand. Those of runs are with the run's outcome. */
public final class ExitCode {
    /** It was done; a mission ended. */
    public static final int OK = 0;

    /** A plan or a file has errors. */
    public static final int FINDINGS = 1;

    /** The command line makes no sense, or a file that it names cannot be read. */
    public static final int USAGE = 2;

    /** Something broke. */
    public static final int FAILED = 4;

    private ExitCode() {}
}
