package org.sami.crw.cli.run;

import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.boat.server.BoatServerDefaults;
import org.sami.boat.server.log.CommandLogFile;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Options of {@code crw boat} for its log. */
final class BoatLogOptions {
    private static final double MEBIBYTE = 1 << 20;
    private static final double MOST_MEBIBYTES = 1 << 20;

    @Spec(Spec.Target.MIXEE)
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Option(
            names = "--log",
            paramLabel = "DIR",
            description =
                    "A folder for its log, NAME.log. An existing log is continued: the boat knows the commands that "
                            + "it has executed, and does not move before a new one.")
    private @Nullable Path folder;

    @Option(
            names = "--log-size",
            paramLabel = "MIB",
            description = "Most MiB of its log: new files begin with what a restarted boat needs, and the oldest go "
                    + "(default " + (BoatServerDefaults.LOG_BYTES >> 20) + ").")
    private double mebibytes = BoatServerDefaults.LOG_BYTES / MEBIBYTE;

    /** Where it is; empty without a log. */
    Optional<Path> folder() {
        return Optional.ofNullable(folder);
    }

    /** Most bytes of the log. */
    long bytes() {
        double least = CommandLogFile.LEAST_BYTES / MEBIBYTE;
        if (!(mebibytes >= least && mebibytes <= MOST_MEBIBYTES)) {
            throw new ParameterException(
                    spec.commandLine(), "--log-size: " + mebibytes + " MiB; a log has " + least + " or more");
        }
        return (long) (mebibytes * MEBIBYTE);
    }
}
