package org.sami.crw.cli.pair;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.sami.crw.cli.output.ExitCode;
import org.sami.pair.postgres.PairDatabase;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code crw pair stop}. */
@Command(
        name = "stop",
        mixinStandardHelpOptions = true,
        description = "Stops this base's database; the next 'crw serve --pair' starts it again.")
final class StopPairCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private PairFolderOption folder = new PairFolderOption();

    @Override
    public Integer call() throws IOException {
        PairDatabase database = PairDatabase.of(folder.folder());
        boolean running = database.isRunning();
        if (running) {
            database.stop();
        }
        spec.commandLine().getOut().println(running ? "the database is stopped" : "the database did not run");
        return ExitCode.OK;
    }
}
