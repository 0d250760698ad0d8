package org.sami.crw.cli.key;

import java.io.Console;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.proxy.key.BaseKeys;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** A file of keys, its password, and the keys of this base: for export and import. */
final class KeyFileOptions {
    @Mixin
    private KeyFolderOption keys = new KeyFolderOption();

    @Parameters(paramLabel = "FILE", description = "The file of keys; export replaces an existing one.")
    private Path file = Path.of("");

    @Option(
            names = "--password-file",
            paramLabel = "FILE",
            description = "Take the password from the first line of this file instead of asking for it.")
    private @Nullable Path passwordFile;

    BaseKeys keys() {
        return keys.keys();
    }

    Path file() {
        return file;
    }

    /** The password in the first line of a file, or typed without being shown. */
    @SuppressWarnings("SystemConsoleNull") // later versions read from whatever the input is, which will do
    char[] password() throws IOException {
        if (passwordFile != null) {
            String text = Files.readString(passwordFile, StandardCharsets.UTF_8);
            return text.lines().findFirst().orElse("").toCharArray();
        }
        Console console = System.console();
        if (console == null) {
            throw new UsageFault("there is no terminal to ask for the password: --password-file FILE");
        }
        char[] typed = console.readPassword("Password of the file: ");
        return typed == null ? new char[0] : typed;
    }
}
