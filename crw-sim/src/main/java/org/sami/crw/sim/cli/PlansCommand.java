package org.sami.crw.sim.cli;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import org.sami.crw.sim.run.Parameters;
import org.sami.crw.sim.run.PlanInterrupts;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw plans}: what the library has. */
@Command(
        name = "plans",
        mixinStandardHelpOptions = true,
        description = "Lists the plans of the library, with what can be set when they start and which interrupts can "
                + "be pressed.",
        footerHeading = "%nExamples:%n",
        footer = {"  crw plans", "  crw plans --json"})
final class PlansCommand implements Callable<Integer> {
    private static final int WIDTH = 96;
    private static final String INDENT = "    ";

    @Spec
    private CommandSpec spec;

    @Option(names = "--json", description = "Print one JSON object.")
    private boolean json;

    @Override
    public Integer call() {
        DomainLibrary library = PlanSource.library();
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(object(library).toPrettyString());
        } else {
            library.plans()
                    .forEach(plan -> print(out, plan, parameters(library, plan).fields(), interrupts(library, plan)));
        }
        out.flush();
        return ExitCode.OK;
    }

    private static void print(PrintWriter out, Plan plan, List<String> parameters, PlanInterrupts interrupts) {
        out.printf("%s  (%s)%n", plan.id(), plan.name());
        out.print(wrapped(plan.description()));
        if (!parameters.isEmpty()) {
            out.print(wrapped("--set " + String.join(", ", parameters)));
        }
        if (!interrupts.names().isEmpty()) {
            out.print(wrapped("--interrupt " + interrupts.inWords()));
        }
        out.println();
    }

    /** Text in lines of a terminal's width, indented. */
    private static String wrapped(String text) {
        StringBuilder lines = new StringBuilder();
        int column = 0;
        for (String word : text.split(" ", -1)) {
            if (column == 0 || column + word.length() >= WIDTH) {
                lines.append(column == 0 ? "" : "\n").append(INDENT);
                column = INDENT.length();
            } else {
                lines.append(' ');
                column++;
            }
            lines.append(word);
            column += word.length();
        }
        return lines.append('\n').toString();
    }

    private static ObjectNode object(DomainLibrary library) {
        ObjectNode json = JsonNodeFactory.instance.objectNode();
        ArrayNode plans = json.putArray("plans");
        for (Plan plan : library.plans()) {
            ObjectNode node = plans.addObject();
            node.put("id", plan.id());
            node.put("name", plan.name());
            node.put("description", plan.description());
            Parameters parameters = parameters(library, plan);
            ArrayNode fields = node.putArray("parameters");
            parameters.fields().forEach(fields::add);
            ArrayNode variables = node.putArray("variables");
            parameters.variables().forEach(variables::add);
            PlanInterrupts interrupts = interrupts(library, plan);
            ArrayNode buttons = node.putArray("interrupts");
            interrupts
                    .names()
                    .forEach(name -> buttons.addObject().put("name", name).put("boats", interrupts.takesBoats(name)));
        }
        return json;
    }

    private static PlanInterrupts interrupts(DomainLibrary library, Plan plan) {
        Project project = library.projectOf(plan.id()).orElseThrow();
        return new PlanInterrupts(library.vocabulary(), project, plan);
    }

    private static Parameters parameters(DomainLibrary library, Plan plan) {
        Project project = library.projectOf(plan.id()).orElseThrow();
        return new Parameters(library.vocabulary(), project, plan);
    }
}
