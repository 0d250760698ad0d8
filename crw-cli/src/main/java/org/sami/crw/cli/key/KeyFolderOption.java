package org.sami.crw.cli.key;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.tcp.BaseProtection;
import picocli.CommandLine.Option;

/** Where the keys of this base are. */
final class KeyFolderOption {
    @Option(
            names = "--keys",
            paramLabel = "DIR",
            description = "The folder of the keys (default: ~/.config/sami/keys); made where there is none.")
    private @Nullable Path folder;

    BaseKeys keys() {
        return new BaseKeys(folder == null ? BaseProtection.folderOfThisUser() : folder);
    }
}
