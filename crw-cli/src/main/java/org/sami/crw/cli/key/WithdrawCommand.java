package org.sami.crw.cli.key;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.Callable;
import org.sami.boat.link.security.Fingerprint;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw keys withdraw}. */
@Command(
        name = "withdraw",
        mixinStandardHelpOptions = true,
        description = "Withdraws keys: the boats take them no longer once this base has commanded them again.")
final class WithdrawCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private KeyFolderOption keys = new KeyFolderOption();

    @Parameters(
            paramLabel = "KEY",
            arity = "1..*",
            description = "A boat's name, or a fingerprint in full: of a laptop that was lost.")
    private List<String> texts = List.of();

    @Override
    public Integer call() throws IOException {
        List<Fingerprint> chosen = UsageFault.of(() -> keys.keys().withdraw(texts));
        for (Fingerprint one : chosen) {
            spec.commandLine()
                    .getOut()
                    .println(one.shortText() + " is withdrawn here; boats learn it when this base commands them next");
        }
        return ExitCode.OK;
    }
}
