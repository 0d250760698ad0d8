package org.sami.crw.cli.pair;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.concurrent.Callable;
import org.sami.crw.cli.output.ExitCode;
import org.sami.pair.postgres.BasePair;
import org.sami.pair.postgres.PairFolder;
import org.sami.pair.postgres.PairSetup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code crw pair rejoin}. */
@Command(
        name = "rejoin",
        mixinStandardHelpOptions = true,
        description = {
            "Has this base follow the other one's database anew: after it was replaced, or was away too long to catch"
                    + " up.",
            "The database that it had is kept beside, with what the other does not have."
        })
final class RejoinPairCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private PairFolderOption folder = new PairFolderOption();

    @Override
    public Integer call() throws IOException {
        PairFolder here = folder.folder();
        BasePair.open(here).checkRejoin();
        String now = DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss").format(LocalDateTime.now(ZoneId.systemDefault()));
        Path kept = PairSetup.copyAgain(here, "until-" + now);
        PrintWriter out = spec.commandLine().getOut();
        out.println("this base follows the database of " + here.settings().other() + " now; here: crw serve --pair");
        out.println("the database that it had is kept in " + kept);
        return ExitCode.OK;
    }
}
