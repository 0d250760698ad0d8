package org.sami.crw.cli.defaults;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw defaults}: the values that hold where nobody says otherwise. */
@Command(
        name = "defaults",
        mixinStandardHelpOptions = true,
        description = {
            "Lists the default values, their effect and where they are set.",
            "They concern boats, links, commands, planning, warnings and files, fields in plans, and options of crw."
        },
        footerHeading = "%nExamples:%n",
        footer = {"  crw defaults", "  crw defaults battery", "  crw defaults --json"})
public final class DefaultsCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(
            paramLabel = "WORD",
            arity = "0..1",
            defaultValue = "",
            description = "Only those with this word in their name or in what they do.")
    private String wanted = "";

    @Option(names = "--json", description = "Print one JSON array.")
    private boolean json;

    @Option(names = "--markdown", description = "Print Markdown tables, as docs/defaults.md has them.")
    private boolean markdown;

    @Override
    public Integer call() {
        if (json && markdown) {
            throw new UsageFault("--json or --markdown, not both");
        }
        List<DefaultValue> found = Stream.of(
                        FleetValues.all(),
                        SimulationValues.all(),
                        PlanValues.of(PlanSource.library().vocabulary()),
                        OptionValues.of(spec.root().commandLine()))
                .flatMap(List::stream)
                .filter(this::isWanted)
                .toList();
        if (found.isEmpty()) {
            throw new UsageFault("no default has '" + wanted + "' in its name or in what it does");
        }
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(array(found).toPrettyString());
        } else if (markdown) {
            out.print(DefaultsText.markdown(found));
        } else {
            out.print(DefaultsText.plain(found));
        }
        out.flush();
        return ExitCode.OK;
    }

    private boolean isWanted(DefaultValue value) {
        return (value.name() + " " + value.meaning())
                .toLowerCase(Locale.ROOT)
                .contains(wanted.toLowerCase(Locale.ROOT));
    }

    private static ArrayNode array(List<DefaultValue> values) {
        ArrayNode array = JsonNodeFactory.instance.arrayNode();
        for (DefaultValue value : values) {
            array.addObject()
                    .put("subject", value.subject())
                    .put("name", value.name())
                    .put("value", value.value())
                    .put("unit", value.unit())
                    .put("meaning", value.meaning())
                    .put("setBy", value.setBy());
        }
        return array;
    }
}
