package org.sami.crw.cli.pair;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.pair.postgres.PairFolder;
import org.sami.pair.postgres.PairMove;
import org.sami.pair.postgres.PairSettings;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw pair address}. */
@Command(
        name = "address",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description = {
            "Tells this base new addresses of the pair, its own or the other's, as in another network. Sessions and"
                    + " databases stay; a running 'crw serve --pair' follows.",
            "To be given on both bases; it says what is to be done on the other."
        })
final class MovePairCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private PairFolderOption folder = new PairFolderOption();

    @Parameters(
            paramLabel = "HOST",
            arity = "0..1",
            description = "The address of the other base (default: that which it had).")
    private @Nullable String other;

    @Option(
            names = "--here",
            paramLabel = "ADDRESS",
            description = "The address of this base, as the other reaches it (default: the one from which this base"
                    + " reaches the other).")
    private @Nullable String here;

    @Override
    public Integer call() throws IOException {
        PairFolder pair = folder.folder();
        String host = other == null ? pair.settings().other() : other;
        PairMove.Change change =
                UsageFault.of(() -> PairMove.to(pair, here == null ? OwnAddress.towards(host) : here, host));
        PrintWriter out = spec.commandLine().getOut();
        PairSettings before = change.before();
        PairSettings after = change.after();
        out.println("this base is " + words(after.here(), before.here()) + ", the other "
                + words(after.other(), before.other()));
        if (change.hasRestarted()) {
            out.println("the database of this base was restarted: it listens at " + after.here() + " now");
        }
        String there = "there: crw pair address " + after.here();
        out.println(
                switch (change.link()) {
                    case CONNECTED -> "the bases are connected: nothing more is to be done";
                    case ANSWERS ->
                        after.other() + " answers, but neither base follows the other. If it was not done" + " yet, "
                                + there + "; else 'crw pair status' says more";
                    case REPLACED_HERE ->
                        after.other() + " took the session over: this base comes back by 'crw pair rejoin'";
                    case REPLACED_THERE ->
                        "this base took the session over: " + after.other() + " comes back by 'crw pair rejoin' there";
                    case REFUSED -> after.other() + " does not let this base in yet; " + there;
                    case SILENT -> after.other() + " does not answer; once it is in this network, " + there;
                });
        return ExitCode.OK;
    }

    private static String words(String now, String before) {
        return now.equals(before) ? now : now + " (before: " + before + ")";
    }
}
