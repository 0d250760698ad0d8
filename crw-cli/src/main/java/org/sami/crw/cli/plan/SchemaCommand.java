package org.sami.crw.cli.plan;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.spn.finding.Suggestions;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw schema}: the JSON Schemas of the files, for editors. */
@Command(
        name = "schema",
        mixinStandardHelpOptions = true,
        description =
                "Prints the JSON Schema (draft 2020-12) of a kind of file, for editors that check and complete as you"
                        + " type.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:done", "2:wrong usage"},
        footerHeading = "%nExamples:%n",
        footer = {"  crw schema > project-1.schema.json", "  crw schema vocabulary"})
public final class SchemaCommand implements Callable<Integer> {
    /** The file name of a project's schema, as projects next to it name it. */
    static final String PROJECT = "project-1.schema.json";

    private static final Map<String, String> FILES = new TreeMap<>(Map.of(
            "project", PROJECT,
            "vocabulary", "vocabulary-1.schema.json",
            "authoring", "authoring-1.schema.json",
            "legacy-classes", "legacy-classes-1.schema.json"));

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(
            paramLabel = "KIND",
            arity = "0..1",
            defaultValue = "project",
            description =
                    "project (a project's file; the default), vocabulary (a domain's files), authoring (its groups and"
                            + " sequences of events) or legacy-classes (a domain's table of class names of the earlier"
                            + " system).")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String kind;

    @Override
    public Integer call() throws IOException {
        String file = FILES.get(kind);
        if (file == null) {
            throw new UsageFault("there is no schema '" + kind + "'; there are " + String.join(", ", FILES.keySet())
                    + Suggestions.meant(FILES.keySet(), kind));
        }
        spec.commandLine().getOut().print(text(file));
        spec.commandLine().getOut().flush();
        return ExitCode.OK;
    }

    /** The text of a schema that ships with the program. */
    static String text(String file) throws IOException {
        try (InputStream in = SchemaCommand.class.getResourceAsStream("/org/sami/schemas/" + file)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
