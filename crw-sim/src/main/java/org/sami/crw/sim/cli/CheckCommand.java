package org.sami.crw.sim.cli;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.concurrent.Callable;
import org.sami.crw.sim.run.PlanInterrupts;
import org.sami.spn.finding.Severity;
import org.sami.spn.json.DomainLibrary;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw check}: what is wrong with a plan or a file. */
@Command(
        name = "check",
        mixinStandardHelpOptions = true,
        description = "Reads a project file and checks its plans; prints what it finds, with the place in the file, "
                + "and the interrupts that the plans offer.",
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
        DomainLibrary library = PlanSource.library();
        PlanSource source = PlanSource.find(name, library);
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            ObjectNode object = FindingsText.json(name, source.findings());
            ObjectNode interrupts = object.putObject("interrupts");
            source.project()
                    .ifPresent(project -> project.plans().forEach(plan -> {
                        ArrayNode names = interrupts.putArray(plan.id());
                        new PlanInterrupts(library.vocabulary(), project, plan)
                                .names()
                                .forEach(names::add);
                    }));
            out.println(object.toPrettyString());
        } else {
            FindingsText.print(out, name, source.findings());
            out.printf(
                    "%s: %d errors, %d warnings%n",
                    name,
                    FindingsText.count(source.findings(), Severity.ERROR),
                    FindingsText.count(source.findings(), Severity.WARNING));
            source.project()
                    .ifPresent(project -> project.plans().forEach(plan -> {
                        PlanInterrupts interrupts = new PlanInterrupts(library.vocabulary(), project, plan);
                        if (!interrupts.names().isEmpty()) {
                            out.printf("%s: --interrupt %s%n", plan.id(), interrupts.inWords());
                        }
                    }));
        }
        out.flush();
        return source.hasErrors() ? ExitCode.FINDINGS : ExitCode.OK;
    }
}
