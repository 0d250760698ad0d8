package org.sami.crw.cli.pair;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.pair.postgres.BasePair;
import org.sami.pair.postgres.SilentBaseException;
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
     * The pair, ready for a session; empty where none was asked for. Waits while the other base does not answer and may have gone on with the session, as when both laptops are switched on.
     *
     * @param lines told for whom it waits, and what a person can do
     * @throws org.sami.pair.postgres.PairException if there is none, or this base must not have the session
     */
    public Optional<PairedBase> open(Consumer<String> lines) throws IOException, InterruptedException {
        if (name == null) {
            return Optional.empty();
        }
        boolean said = false;
        while (true) {
            BasePair pair = BasePair.open(folder.folder()); // anew, as it may have been told another address meanwhile
            try {
                return Optional.of(PairedBase.of(pair, pair.checkedPart(name), name));
            } catch (SilentBaseException silent) {
                if (!said) {
                    lines.accept(silent.getMessage() + ": this base waits until it answers. If it has not, and is off:"
                            + " crw pair alone; if it has another address: crw pair address");
                }
                said = true;
                TimeUnit.SECONDS.sleep(1);
            }
        }
    }
}
