package org.sami.crw.cli.plan;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.DomainOption;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.sim.run.settings.Parameters;
import org.sami.crw.sim.run.settings.PlanInterrupts;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw plans}: what the library has. */
@Command(
        name = "plans",
        mixinStandardHelpOptions = true,
        description = "Lists the plans of the library or of a file, with what can be set when they start and which"
                + " interrupts can be pressed.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw plans",
            "  crw plans station-keep",
            "  crw plans --domain uav",
            "  crw plans my-project.json --json"
        })
public final class PlansCommand implements Callable<Integer> {
    private static final int WIDTH = 96;
    private static final String INDENT = "    ";

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @CommandLine.Parameters(
            paramLabel = "PLAN|FILE",
            arity = "0..1",
            description = "Only this plan of the library, or the plans of this project's file or folder.")
    private @Nullable String name;

    @CommandLine.Mixin
    private DomainOption domain = new DomainOption();

    @Option(names = "--json", description = "Print one JSON object.")
    private boolean json;

    /** A plan with the project that it belongs to. */
    private record Shown(Vocabulary vocabulary, Project project, Plan plan) {
        Parameters parameters() {
            return new Parameters(vocabulary, project, plan);
        }

        PlanInterrupts interrupts() {
            return new PlanInterrupts(vocabulary, project, plan);
        }
    }

    @Override
    public Integer call() {
        PrintWriter err = spec.commandLine().getErr();
        Reading<DomainLibrary> reading = domain.read();
        if (reading.hasErrors()) {
            FindingsText.print(err, domain.name(), reading.findings());
            err.flush();
            return ExitCode.FINDINGS;
        }
        DomainLibrary library = reading.orThrow();
        List<Shown> plans;
        if (name == null) {
            plans = library.plans().stream()
                    .map(plan -> new Shown(
                            library.vocabulary(), library.projectOf(plan.id()).orElseThrow(), plan))
                    .toList();
        } else {
            PlanSource source = PlanSource.find(name, library);
            if (source.project().isEmpty()) {
                FindingsText.print(err, name, source.findings());
                err.flush();
                return ExitCode.FINDINGS;
            }
            Project project = source.project().get();
            plans = source.plan().map(List::of).orElse(project.plans()).stream()
                    .map(plan -> new Shown(library.vocabulary(), project, plan))
                    .toList();
        }
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(object(plans).toPrettyString());
        } else {
            plans.forEach(plan -> print(out, plan));
        }
        out.flush();
        return ExitCode.OK;
    }

    private static void print(PrintWriter out, Shown shown) {
        Plan plan = shown.plan();
        out.printf("%s  (%s)%n", plan.id(), plan.title());
        if (!plan.description().isEmpty()) {
            out.print(wrapped(plan.description()));
        }
        shown.parameters().describe().forEach(parameter -> out.println(INDENT + "--set " + line(parameter)));
        if (!shown.interrupts().names().isEmpty()) {
            out.print(wrapped("--interrupt " + shown.interrupts().inWords()));
        }
        out.println();
    }

    private static String line(Parameters.Description parameter) {
        String line = parameter.name() + "=" + parameter.type();
        if (!parameter.editable()) {
            return line + "  (locked at " + parameter.preset().orElseThrow() + ")";
        }
        return line + parameter.preset().map(value -> "  (" + value + ")").orElse("");
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

    private static ObjectNode object(List<Shown> plans) {
        ObjectNode json = JsonNodeFactory.instance.objectNode();
        ArrayNode list = json.putArray("plans");
        for (Shown shown : plans) {
            ObjectNode node = list.addObject();
            node.put("id", shown.plan().id());
            node.put("name", shown.plan().name());
            node.put("description", shown.plan().description());
            ArrayNode parameters = node.putArray("parameters");
            shown.parameters().describe().forEach(parameter -> {
                ObjectNode one = parameters.addObject();
                one.put("name", parameter.name());
                one.put("type", parameter.type());
                parameter.preset().ifPresent(value -> one.set("default", value));
                one.put("editable", parameter.editable());
            });
            PlanInterrupts interrupts = shown.interrupts();
            ArrayNode buttons = node.putArray("interrupts");
            interrupts
                    .names()
                    .forEach(name -> buttons.addObject().put("name", name).put("boats", interrupts.takesBoats(name)));
        }
        return json;
    }
}
