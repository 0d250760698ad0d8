package org.sami.crw.cli.plan;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw new}: a small project to begin with. */
@Command(
        name = "new",
        mixinStandardHelpOptions = true,
        description = "Makes a project file with one small plan that can be checked, tested and run: the chosen boats "
                + "gather around a location. Change it to your needs.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:it was made", "2:wrong usage, or the file is there already", "4:it cannot be written"},
        footerHeading = "%nExamples:%n",
        footer = {"  crw new survey            makes survey.json", "  crw new plans/survey.json"})
public final class NewCommand implements Callable<Integer> {
    private static final String TEMPLATE = "new-project.json";
    private static final String ENDING = ".json";

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(paramLabel = "NAME", description = "The project's name, which the file gets as well; or the file.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String name;

    @Option(names = "--replace", description = "Replace a file that is there already.")
    private boolean replace;

    @Option(
            names = "--schema",
            description =
                    "Name the JSON Schema of projects in the file, and put it next to the file unless it is there: "
                            + "an editor then checks and completes as you type.")
    private boolean schema;

    @Override
    public Integer call() throws IOException {
        Path file = Path.of(name.endsWith(ENDING) ? name : name + ENDING);
        boolean there = Files.exists(file);
        if (there && (!replace || Files.isDirectory(file))) {
            throw new UsageFault(file + " is there already; it is left as it is"
                    + (Files.isDirectory(file) ? "" : " (--replace replaces it)"));
        }
        String title = file.getFileName().toString();
        title = title.substring(0, title.length() - ENDING.length());
        DomainLibrary library = PlanSource.library();
        Project project = named(template(library), title);
        if (file.getParent() != null) {
            Files.createDirectories(file.getParent());
        }
        new ProjectWriter(library.vocabulary()).write(project, file);
        PrintWriter out = spec.commandLine().getOut();
        Path beside = file.resolveSibling(SchemaCommand.PROJECT);
        if (schema && !Files.exists(beside)) {
            Files.writeString(beside, SchemaCommand.text(SchemaCommand.PROJECT));
            out.println("made " + beside);
        }
        out.println((there ? "replaced " : "made ") + file + "; go on with:");
        out.println("  crw check " + file);
        out.println("  crw test " + file);
        out.println("  crw run " + file + " --speed max");
        out.flush();
        return ExitCode.OK;
    }

    private static Project template(DomainLibrary library) throws IOException {
        try (InputStream in = NewCommand.class.getResourceAsStream(TEMPLATE)) {
            String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
            return new ProjectReader(library.vocabulary()).read(text).orThrow();
        }
    }

    private Project named(Project template, String title) {
        Plan plan = template.plans().get(0);
        String id = id(title);
        Plan named = new Plan(
                id,
                title,
                plan.description(),
                plan.places(),
                plan.transitions(),
                plan.inEdges(),
                plan.outEdges(),
                plan.variables(),
                plan.reads(),
                plan.tasks(),
                plan.layout(),
                plan.notes(),
                plan.frames(),
                plan.testCases(),
                plan.queries());
        MissionTreeNode tree = new MissionTreeNode("", Optional.of(id), List.of());
        return new Project(
                id,
                title,
                template.domain(),
                template.globals(),
                List.of(tree),
                List.of(named),
                schema ? Optional.of(SchemaCommand.PROJECT) : Optional.empty(),
                Optional.empty());
    }

    /** An id of what can stand in one; other characters become hyphens. */
    private static String id(String title) {
        String id =
                title.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9_.]+", "-").replaceAll("^-+|-+$", "");
        return id.isEmpty() ? "plan" : id;
    }
}
