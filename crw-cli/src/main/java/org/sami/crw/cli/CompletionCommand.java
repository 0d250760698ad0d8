package org.sami.crw.cli;

import java.io.PrintWriter;
import java.util.concurrent.Callable;
import org.sami.crw.cli.output.ExitCode;
import picocli.AutoComplete;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw completion}: what a shell needs to complete commands and options. */
@Command(
        name = "completion",
        mixinStandardHelpOptions = true,
        description = "Prints a script that has a shell complete commands and options of crw.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  eval \"$(crw completion bash)\"             in ~/.bashrc",
            "  eval \"$(crw completion zsh)\"              in ~/.zshrc"
        })
final class CompletionCommand implements Callable<Integer> {
    /** The shells that have it. */
    enum Shell {
        BASH,
        ZSH
    }

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(paramLabel = "SHELL", description = "bash or zsh.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private Shell shell;

    @Override
    public Integer call() {
        PrintWriter out = spec.commandLine().getOut();
        if (shell == Shell.ZSH) { // where nothing has loaded completion yet
            out.println("autoload -Uz compinit && compinit -i");
        }
        out.println(AutoComplete.bash("crw", spec.root().commandLine())); // for both: zsh runs it with bashcompinit
        out.flush();
        return ExitCode.OK;
    }
}
