package org.sami.crw.sim.cli;

import java.io.PrintWriter;
import java.util.concurrent.Callable;
import org.sami.spn.finding.Severity;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw check}: what is wrong with a plan or a file. */
@Command(
        name = "check",
        mixinStandardHelpOptions = true,
        description = "Reads a project file and checks its plans; prints what it finds, with the place in the file.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:no errors; there may be warnings",
            "1:there are errors: the plan would not be started",
            "2:wrong usage, or there is no such file"
        },
        footerHeading = "%nExamples:%n",
        footer = {"  crw check my-plan.json", "  crw check clv --json"})
final class CheckCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "FILE|PLAN",
            description = "A project's file or folder, or a plan of the library by its id.")
    private String name;

    @Option(names = "--json", description = "Print one JSON object.")
    private boolean json;

    @Override
    public Integer call() {
        PlanSource source = PlanSource.find(name, PlanSource.library());
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(FindingsText.json(name, source.findings()).toPrettyString());
        } else {
            FindingsText.print(out, name, source.findings());
            out.printf(
                    "%s: %d errors, %d warnings%n",
                    name,
                    FindingsText.count(source.findings(), Severity.ERROR),
                    FindingsText.count(source.findings(), Severity.WARNING));
        }
        out.flush();
        return source.hasErrors() ? ExitCode.FINDINGS : ExitCode.OK;
    }
}
