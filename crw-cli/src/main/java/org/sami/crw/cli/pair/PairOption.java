package org.sami.crw.cli.pair;

import java.io.IOException;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.pair.postgres.BasePair;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** That a session is one of this base's pair. */
public final class PairOption {
    static final String NAME = "sami";

    @Mixin
    private PairFolderOption folder = new PairFolderOption();

    @Option(
            names = "--pair",
            paramLabel = "NAME",
            arity = "0..1",
            fallbackValue = NAME,
            description =
                    "Keep the session in the database of this base's pair ('crw pair'), under a name (sami). The base"
                            + " whose database is the replica stands by, and goes on with the session when the other is"
                            + " lost.")
    private @Nullable String name;

    /**
     * The pair, ready for a session; empty where none was asked for.
     *
     * @throws org.sami.pair.postgres.PairException if there is none, or this base must not have the session
     */
    public Optional<PairedBase> open() throws IOException {
        return name == null ? Optional.empty() : Optional.of(PairedBase.of(BasePair.open(folder.folder()), name));
    }
}
