package org.sami.crw.sim.cli;

/** The exit codes of the command, the same for every subcommand. Those of runs are with the run's outcome. */
final class ExitCode {
    /** It was done; a mission ended. */
    static final int OK = 0;

    /** A plan or a file has errors. */
    static final int FINDINGS = 1;

    /** The command line makes no sense, or a file that it names cannot be read. */
    static final int USAGE = 2;

    /** Something broke. */
    static final int FAILED = 4;

    private ExitCode() {}
}
