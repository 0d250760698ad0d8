package org.sami.crw.cli.option;

import org.sami.crw.cli.output.UsageFault;
import picocli.CommandLine.Option;

/** The option {@code --depth}: how many levels of sub-missions the net of a plan follows. */
public final class DepthOption {
    private static final int MOST = 5;

    @Option(
            names = "--depth",
            paramLabel = "N",
            defaultValue = "0",
            description = "How many levels of sub-missions the net of a plan follows; deeper ones may end at any time."
                    + " Default: ${DEFAULT-VALUE}.")
    private int depth;

    /** Nothing was read yet: none are followed. */
    public DepthOption() {}

    /**
     * So many levels.
     *
     * @throws UsageFault if there are fewer than none, or too many
     */
    public int levels() {
        if (depth < 0 || depth > MOST) {
            throw new UsageFault("--depth is 0 to " + MOST + ", not " + depth);
        }
        return depth;
    }
}
