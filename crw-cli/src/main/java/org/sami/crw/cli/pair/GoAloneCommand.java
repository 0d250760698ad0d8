package org.sami.crw.cli.pair;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.pair.postgres.BasePair;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw pair alone}. */
@Command(
        name = "alone",
        mixinStandardHelpOptions = true,
        description = "Has this base go on without its standby, which is off. Nothing is done without --confirm.")
final class GoAloneCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private PairFolderOption folder = new PairFolderOption();

    @Option(names = "--confirm", description = "Do it.")
    private boolean confirm;

    @Override
    public Integer call() throws IOException {
        BasePair pair = BasePair.open(folder.folder());
        String other = pair.settings().other();
        if (!confirm) {
            throw new UsageFault("if " + other + " still runs 'crw serve --pair', it may have gone on with the session,"
                    + " and both would command. End it there or switch it off, then: crw pair alone --confirm");
        }
        pair.goAlone();
        spec.commandLine()
                .getOut()
                .println("this base goes on without " + other
                        + "; once 'crw serve --pair' runs there again, the session is protected again");
        return ExitCode.OK;
    }
}
