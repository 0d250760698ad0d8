package org.sami.crw.cli.pair;

import java.io.IOException;
import java.io.PrintWriter;
import java.sql.SQLException;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.journal.postgres.DatabaseFaults;
import org.sami.journal.postgres.PostgresAddress;
import org.sami.journal.postgres.TakeOver;
import org.sami.pair.postgres.BasePair;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw take-over}: has the base that stands by go on with the session now. */
@Command(
        name = "take-over",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description = {
            "Has the base that stands by ('crw serve --standby', or '--pair' on the second base) go on with the session"
                    + " now. The base that has it stops commanding as soon as it looks, within a second.",
            "Of a pair, on the base that stands by. Says first what would be lost, and does nothing then without"
                    + " --confirm."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the session is free for the base that stands by",
            "2:wrong usage, or something would be lost, which is to be confirmed",
            "4:there is no pair, or the database does not answer"
        },
        footerHeading = "%nExamples:%n",
        footer = {"  crw take-over", "  crw take-over 'postgresql://base-db/boats?user=pilot'"})
public final class TakeOverCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private PairFolderOption folder = new PairFolderOption();

    @Parameters(
            paramLabel = "JOURNAL",
            arity = "0..1",
            description = "The session's journal in a database that both bases reach; without it, that of the pair.")
    private @Nullable String journal;

    @Option(
            names = "--pair",
            paramLabel = "NAME",
            description = "The name of the session in the pair's database (default: ${DEFAULT-VALUE}).")
    private String name = PairOption.NAME;

    @Option(names = "--confirm", description = "Do it, also where something is lost.")
    private boolean confirm;

    @Override
    public Integer call() throws IOException {
        Optional<String> holder = journal == null ? ofPair() : ofDatabase(journal);
        PrintWriter out = spec.commandLine().getOut();
        out.println(
                holder.isPresent()
                        ? "taken from " + holder.get() + "; the base that stands by goes on with it"
                        : "nobody holds the session: the base that stands by goes on with it");
        return ExitCode.OK;
    }

    private Optional<String> ofPair() throws IOException {
        BasePair pair = BasePair.open(folder.folder());
        Optional<String> loss = pair.lossOfTakeOver(name);
        if (loss.isPresent() && !confirm) {
            throw new UsageFault(loss.get() + ". To do it: crw take-over --confirm");
        }
        return pair.takeOver(name, confirm);
    }

    private static Optional<String> ofDatabase(String text) throws IOException {
        PostgresAddress address = UsageFault.of(() -> PostgresAddress.parse(text));
        try {
            return TakeOver.takeAway(address);
        } catch (SQLException fault) {
            throw new IOException(address.words() + ": " + DatabaseFaults.words(fault), fault);
        }
    }
}
