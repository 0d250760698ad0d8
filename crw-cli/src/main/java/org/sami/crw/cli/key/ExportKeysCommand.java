package org.sami.crw.cli.key;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.security.KeyBundle;
import org.sami.boat.link.security.KeyRing;
import org.sami.crw.cli.output.ExitCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
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
    private KeyFolderOption keys = new KeyFolderOption();

    @Parameters(paramLabel = "FILE", description = "The file; an existing one is replaced.")
    private Path file = Path.of("");

    @Option(
            names = "--password-file",
            paramLabel = "FILE",
            description = "Take the password from the first line of this file instead of asking for it.")
    private @Nullable Path passwordFile;

    @Override
    public Integer call() throws IOException {
        KeyRing ring = keys.folder().open();
        char[] password = KeyFolderOption.password(passwordFile);
        KeyBundle.write(file, ring, password);
        Arrays.fill(password, ' ');
        spec.commandLine()
                .getOut()
                .println(file + ": this base's key and " + ring.peers().size() + " boats");
        return ExitCode.OK;
    }
}
