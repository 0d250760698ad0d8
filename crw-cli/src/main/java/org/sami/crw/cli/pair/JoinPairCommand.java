package org.sami.crw.cli.pair;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.sami.crw.cli.output.ExitCode;
import org.sami.pair.postgres.Invitation;
import org.sami.pair.postgres.PairSetup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw pair join}. */
@Command(
        name = "join",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description = "Makes this base the second one of a pair: copies the first one's database and follows it.")
final class JoinPairCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private PairFolderOption folder = new PairFolderOption();

    @Mixin
    private ProgramsOption programs = new ProgramsOption();

    @Parameters(paramLabel = "FILE", description = "The invitation that 'crw pair init' wrote on the first base.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private Path invitation;

    @Override
    public Integer call() throws IOException {
        Invitation read = Invitation.read(invitation);
        PairSetup.join(folder.folder(), programs.programs(), read);
        PrintWriter out = spec.commandLine().getOut();
        out.println("this base, " + read.settings().here() + ", follows the database of "
                + read.settings().other() + " in " + folder.folder().path());
        out.println("on both: crw serve --pair; " + read.settings().other() + " has the session, this base stands by");
        out.println(invitation + " is not needed any more: delete it");
        return ExitCode.OK;
    }
}
