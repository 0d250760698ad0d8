package org.sami.crw.cli.key;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.sami.boat.link.security.KeyRing;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code crw keys export}. */
@Command(
        name = "export",
        mixinStandardHelpOptions = true,
        description = "Writes all keys of this base to one encrypted file, to take them to a second laptop.")
final class ExportKeysCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private KeyFileOptions options = new KeyFileOptions();

    @Override
    public Integer call() throws IOException {
        KeyRing ring = UsageFault.of(() -> options.keys().exportTo(options.file(), options.password()));
        spec.commandLine()
                .getOut()
                .println(
                        options.file() + ": this base's key and " + ring.peers().size() + " boats");
        return ExitCode.OK;
    }
}
