package org.sami.crw.cli.option;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.LostLinkAction;
import picocli.CommandLine.Option;

/** What a session wishes that its boats do when their link is lost. */
public final class LostLinkOption {
    @Option(
            names = "--lost-link",
            paramLabel = "ACTION",
            description = "What boats and vehicles are to do when their link is lost: hold, return, continue or drift."
                    + " The check before a launch says which of them do something else, and sets them where it is told"
                    + " to; a run sets them itself (default: nothing is wished).")
    private @Nullable LostLinkAction wish;

    /** What is wished; empty where the option was not given. */
    public Optional<LostLinkAction> wish() {
        return Optional.ofNullable(wish);
    }
}
