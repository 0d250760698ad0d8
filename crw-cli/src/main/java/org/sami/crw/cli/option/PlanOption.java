package org.sami.crw.cli.option;

import picocli.CommandLine.Option;

/** The option {@code --plan} of commands that take one plan of a project. */
public final class PlanOption {
    @Option(
            names = "--plan",
            paramLabel = "NAME",
            defaultValue = "",
            description = "Which plan of a project with several; its id or name.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String name;

    /** As it was given; empty text where it was not. */
    public String name() {
        return name;
    }
}
