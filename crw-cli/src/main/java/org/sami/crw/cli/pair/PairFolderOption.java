package org.sami.crw.cli.pair;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.sami.pair.postgres.PairFolder;
import picocli.CommandLine.Option;

/** Where this base's part of a pair is. */
public final class PairFolderOption {
    @Option(
            names = "--pair-folder",
            paramLabel = "DIR",
            description = "The folder of the pair, with this base's database (default: ~/.config/sami/pair).")
    private @Nullable Path folder;

    /** The folder that was named, or the user's. */
    public PairFolder folder() {
        return new PairFolder(
                folder == null ? Path.of(System.getProperty("user.home"), ".config", "sami", "pair") : folder);
    }
}
