package org.sami.crw.cli.key;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.sami.boat.link.security.KeyRing;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw keys import}. */
@Command(
        name = "import",
        mixinStandardHelpOptions = true,
        description = "Takes the keys of such a file, in place of the keys of this base.")
final class ImportKeysCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private KeyFileOptions options = new KeyFileOptions();

    @Option(names = "--replace", description = "Give up the keys that this base has.")
    private boolean replace;

    @Override
    public Integer call() throws IOException {
        if (options.keys().exist() && !replace) {
            throw new UsageFault("this base has keys already; --replace to give them up for those of the file");
        }
        KeyRing ring = UsageFault.of(() -> options.keys().importFrom(options.file(), options.password(), replace));
        spec.commandLine()
                .getOut()
                .println(
                        "this base has the key " + ring.identity().fingerprint().shortText() + " and "
                                + ring.peers().size() + " boats now");
        return ExitCode.OK;
    }
}
