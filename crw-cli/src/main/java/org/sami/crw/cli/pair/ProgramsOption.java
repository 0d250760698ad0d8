package org.sami.crw.cli.pair;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.sami.pair.postgres.PairException;
import org.sami.pair.postgres.Programs;
import picocli.CommandLine.Option;

/** Which PostgreSQL is used. */
final class ProgramsOption {
    @Option(
            names = "--postgres",
            paramLabel = "DIR",
            description = "The folder of PostgreSQL's programs (default: the newest that is installed).")
    private @Nullable Path folder;

    Programs programs() throws PairException {
        return folder == null
                ? Programs.installed().orElseThrow(() -> new PairException(Programs.HOW_TO_GET))
                : Programs.in(folder);
    }
}
