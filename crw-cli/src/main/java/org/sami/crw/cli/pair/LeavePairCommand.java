package org.sami.crw.cli.pair;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.pair.postgres.PairDatabase;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw pair leave}. */
@Command(
        name = "leave",
        mixinStandardHelpOptions = true,
        description = "Deletes the pair on this base, with its sessions. Nothing is done without --confirm.")
final class LeavePairCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private PairFolderOption folder = new PairFolderOption();

    @Option(names = "--confirm", description = "Do it.")
    private boolean confirm;

    @Override
    public Integer call() throws IOException {
        PairDatabase database = PairDatabase.of(folder.folder());
        if (!confirm) {
            throw new UsageFault("the sessions in " + folder.folder().path()
                    + " are deleted with it; 'crw copy-journal' keeps one in a file. To do it: crw pair leave"
                    + " --confirm");
        }
        database.delete();
        spec.commandLine().getOut().println(folder.folder().path() + " is deleted");
        return ExitCode.OK;
    }
}
