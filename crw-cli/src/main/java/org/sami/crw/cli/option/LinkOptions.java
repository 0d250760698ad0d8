package org.sami.crw.cli.option;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.proxy.tcp.BaseProtection;
import picocli.CommandLine.Option;

/** How a base protects its links to boats. */
public final class LinkOptions {
    @Option(
            names = "--keys",
            paramLabel = "DIR",
            description =
                    "The keys of this base, with which all links are protected, also those to this machine (default:"
                            + " ~/.config/sami/keys, for boats on other machines; boats on this machine are linked"
                            + " plainly).")
    private @Nullable Path keys;

    @Option(
            names = "--open",
            description = "Link boats on other machines plainly: whoever reaches them can command them.")
    private boolean open;

    /**
     * Makes this process use what the options say.
     *
     * @throws UsageFault if they contradict each other, or the keys are no folder
     */
    public void use() {
        if (keys != null && open) {
            throw new UsageFault("--open and --keys contradict each other");
        }
        if (keys != null && Files.exists(keys) && !Files.isDirectory(keys)) {
            throw new UsageFault("--keys: " + keys + " is a file: the keys of a base are a folder");
        }
        new BaseProtection(Optional.ofNullable(keys), open).use();
    }
}
