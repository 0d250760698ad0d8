package org.sami.crw.cli.key;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.security.KeyBundle;
import org.sami.boat.link.security.KeyRing;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
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
    private KeyFolderOption keys = new KeyFolderOption();

    @Parameters(paramLabel = "FILE", description = "What 'crw keys export' has written.")
    private Path file = Path.of("");

    @Option(names = "--replace", description = "Give up the keys that this base has.")
    private boolean replace;

    @Option(
            names = "--password-file",
            paramLabel = "FILE",
            description = "Take the password from the first line of this file instead of asking for it.")
    private @Nullable Path passwordFile;

    @Override
    public Integer call() throws IOException {
        if (keys.folder().exists() && !replace) {
            throw new UsageFault("this base has keys already; --replace to give them up for those of the file");
        }
        char[] password = KeyFolderOption.password(passwordFile);
        KeyRing ring = KeyBundle.read(file, password, keys.folder());
        Arrays.fill(password, ' ');
        spec.commandLine()
                .getOut()
                .println(
                        "this base has the key " + ring.identity().fingerprint().shortText() + " and "
                                + ring.peers().size() + " boats now");
        return ExitCode.OK;
    }
}
