package org.sami.crw.cli.option;

import java.nio.file.Path;
import java.util.Optional;
import org.sami.crw.proxy.tcp.BaseProtection;
import picocli.CommandLine.Option;

/** How a base protects its links to boats. */
public final class LinkOptions {
    @Option(
            names = "--keys",
            paramLabel = "DIR",
            description =
                    "The keys of this base, with which all links are protected, also those to this machine "
                            + "(default: ~/.config/sami/keys, for boats on other machines; boats on this machine are linked plainly).")
    private Path keys;

    @Option(
            names = "--open",
            description = "Link boats on other machines plainly: whoever reaches them can command them.")
    private boolean open;

    /** Makes this process use what the options say. */
    public void use() {
        new BaseProtection(Optional.ofNullable(keys), open).use();
    }
}
