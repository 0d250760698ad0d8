package org.sami.crw.cli.pair;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.sami.crw.cli.output.ExitCode;
import org.sami.pair.postgres.BasePair;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code crw pair status}. */
@Command(
        name = "status",
        mixinStandardHelpOptions = true,
        description = "Says what this base and the other one are at present, and whether the session is protected.")
final class PairStatusCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private PairFolderOption folder = new PairFolderOption();

    @Override
    public Integer call() throws IOException {
        spec.commandLine().getOut().println(BasePair.open(folder.folder()).standing());
        return ExitCode.OK;
    }
}
