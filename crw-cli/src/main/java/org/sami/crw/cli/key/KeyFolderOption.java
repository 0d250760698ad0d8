package org.sami.crw.cli.key;

import java.io.Console;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.proxy.tcp.BaseProtection;
import picocli.CommandLine.Option;

/** Where the keys of this base are. */
final class KeyFolderOption {
    private static final int SHORTEST_PASSWORD = 8;

    @Option(
            names = "--keys",
            paramLabel = "DIR",
            description = "The folder of the keys (default: ~/.config/sami/keys); made where there is none.")
    private @Nullable Path folder;

    KeyStoreFolder folder() {
        return new KeyStoreFolder(folder == null ? BaseProtection.folderOfThisUser() : folder);
    }

    /** The password in the first line of a file, or typed without being shown. */
    @SuppressWarnings("SystemConsoleNull") // later versions read from whatever the input is, which will do
    static char[] password(@Nullable Path file) throws IOException {
        char[] password;
        if (file != null) {
            String text = Files.readString(file, StandardCharsets.UTF_8);
            password = text.lines().findFirst().orElse("").toCharArray();
        } else {
            Console console = System.console();
            if (console == null) {
                throw new UsageFault("there is no terminal to ask for the password: --password-file FILE");
            }
            char[] typed = console.readPassword("Password of the file: ");
            password = typed == null ? new char[0] : typed;
        }
        if (password.length < SHORTEST_PASSWORD) {
            Arrays.fill(password, ' ');
            throw new UsageFault("a password has " + SHORTEST_PASSWORD + " characters at least");
        }
        return password;
    }
}
