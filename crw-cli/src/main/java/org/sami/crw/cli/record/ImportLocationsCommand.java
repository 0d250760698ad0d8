package org.sami.crw.cli.record;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.geotext.GeoWords;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.UsageFault;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;
import org.sami.spn.geotext.GeoMeaning;
import org.sami.spn.geotext.GeoText;
import org.sami.spn.geotext.GeoTextReader;
import org.sami.spn.geotext.GeoVariables;
import org.sami.spn.geotext.LineFinding;
import org.sami.spn.geotext.ProjectVariables;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.TypeNames;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw import-locations}: points, paths and areas of the earlier system's text files as variables of a project. */
@Command(
        name = "import-locations",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description = {
            "Reads locations, paths or areas from a text file of the earlier system, checks them, and writes them as"
                    + " global variables into a project, new or there already.",
            "A line of the file is LAT,LON in degrees, '[', ']' or a comment that begins with #."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:read, and written where a project was named",
            "1:the file or the project has errors; nothing was written",
            "2:wrong usage, no such file, or a variable of that name is there already"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw import-locations beach.txt --as areas                     only look",
            "  crw import-locations beach.txt beach.json --as areas          as the variable @beach, a list of areas",
            "  crw import-locations beach.txt beach.json --as areas --each   as @beach1, @beach2, ...",
        })
public final class ImportLocationsCommand implements Callable<Integer> {
    private static final Pattern NAME = Pattern.compile("@[A-Za-z][A-Za-z0-9_.]*");

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(index = "0", paramLabel = "FILE", description = "The text file.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private Path file;

    @Parameters(
            index = "1",
            arity = "0..1",
            paramLabel = "PROJECT",
            description =
                    "The project's file or folder; a file that is not there is made. Without it nothing is written.")
    private @Nullable Path projectPath;

    @Option(
            names = "--as",
            paramLabel = "MEANING",
            description = "What the points are: ${COMPLETION-CANDIDATES}. Needed where the file can mean several, "
                    + "unless the variable is there already and is replaced.")
    private @Nullable GeoMeaning meaning;

    @Option(
            names = "--name",
            paramLabel = "@NAME",
            description = "The variable's name (default: the file's, without its ending).")
    private @Nullable String name;

    @Option(names = "--each", description = "A variable for each path or area, numbered from 1, not one list of all.")
    private boolean each;

    @Option(names = "--replace", description = "Replace variables of the same name.")
    private boolean replace;

    @Override
    public Integer call() throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new UsageFault("there is no file " + file);
        }
        byte[] bytes = BoundedFile.bytes(file, BoundedFile.DATA_BYTES);
        return BoundedFile.making(file, () -> declare(bytes));
    }

    private int declare(byte[] bytes) throws IOException {
        String variable = variableName();
        GeoTextReader.Result read = GeoTextReader.read(bytes);
        print(read.findings());
        if (read.text().isEmpty()) {
            return ExitCode.FINDINGS;
        }
        DomainLibrary library = PlanSource.library();
        Optional<Project> project = Optional.empty();
        Path target = projectPath;
        if (target != null) {
            project = project(target, library);
            if (project.isEmpty()) {
                return ExitCode.FINDINGS;
            }
        }
        GeoText text = read.text().get();
        GeoVariables.Result made = GeoVariables.of(text, meaning(text, variable, project), variable, each);
        print(made.findings());
        if (made.variables().isEmpty()) {
            return ExitCode.FINDINGS;
        }
        PrintWriter out = spec.commandLine().getOut();
        made.variables().forEach(v -> out.print(GeoWords.text(v)));
        if (target != null && project.isPresent()) {
            write(project.get(), made.variables(), target, library);
        }
        out.flush();
        return ExitCode.OK;
    }

    private String variableName() {
        if (name != null) {
            String wanted = name.startsWith("@") ? name : "@" + name;
            if (!NAME.matcher(wanted).matches() || wanted.equals("@task")) {
                throw new UsageFault("--name: a variable's name is @ and a letter, then letters, digits, points, not "
                        + name + "; @task is reserved");
            }
            return wanted;
        }
        String base = file.getFileName().toString().replaceFirst("\\.[^.]*$", "");
        String made = "@" + base.replaceAll("[^A-Za-z0-9_]+", "_").replaceFirst("^[^A-Za-z]+", "");
        if (!NAME.matcher(made).matches() || made.equals("@task")) {
            throw new UsageFault("no variable can be called as " + file + " is; say --name");
        }
        return made;
    }

    private Optional<Project> project(Path target, DomainLibrary library) {
        if (!Files.exists(target)) {
            if (!target.toString().toLowerCase(Locale.ROOT).endsWith(".json")) {
                throw new UsageFault("there is no project " + target + "; a new one is a file that ends in .json");
            }
            String id = target.getFileName().toString().replaceFirst("\\.[^.]*$", "");
            return Optional.of(new Project(id, "", library.vocabulary().domain(), List.of(), List.of(), List.of()));
        }
        Reading<Project> reading = new ProjectReader(library.vocabulary()).read(target);
        if (reading.result().isEmpty()) {
            List<Finding> errors =
                    reading.findings().stream().filter(Finding::isError).toList();
            PrintWriter err = spec.commandLine().getErr();
            FindingsText.print(err, target.toString(), errors);
            err.flush();
        }
        return reading.result();
    }

    private GeoMeaning meaning(GeoText text, String variable, Optional<Project> project) {
        List<GeoMeaning> possible = GeoMeaning.of(text.nesting());
        if (meaning != null) {
            if (!possible.contains(meaning)) {
                throw new UsageFault("--as: " + file + " is " + text.words() + ", which can be "
                        + GeoMeaning.choices(text.nesting()) + ", not " + meaning.word());
            }
            return meaning;
        }
        Optional<GeoMeaning> replaced = project.filter(p -> replace)
                .flatMap(p -> p.globals().stream()
                        .filter(global -> global.name().equals(each ? variable + "1" : variable))
                        .findFirst()
                        .flatMap(global -> possible.stream()
                                .filter(m -> (each ? m.ofOne() : m).type().equals(global.type()))
                                .findFirst()));
        if (possible.size() == 1) {
            return possible.get(0);
        }
        return replaced.orElseThrow(() -> new UsageFault(
                file + " is " + text.words() + "; say what that is with --as " + GeoMeaning.choices(text.nesting())));
    }

    private void write(Project project, List<VariableSpec> variables, Path target, DomainLibrary library)
            throws IOException {
        List<String> collisions = ProjectVariables.collisions(project, variables);
        if (!collisions.isEmpty() && !replace) {
            throw new UsageFault(target + " has " + String.join(", ", collisions)
                    + " already; --replace replaces, --name gives another name");
        }
        for (VariableSpec variable : variables) {
            for (VariableSpec old : project.globals()) {
                if (old.name().equals(variable.name()) && !old.type().equals(variable.type())) {
                    throw new UsageFault(old.name() + " in " + target + " is of the type " + TypeNames.of(old.type())
                            + ", not " + TypeNames.of(variable.type()) + "; the plans that use it would break");
                }
            }
        }
        new ProjectWriter(library.vocabulary()).write(ProjectVariables.with(project, variables), target);
        PrintWriter err = spec.commandLine().getErr();
        err.println("written to " + target);
        err.flush();
    }

    private void print(List<LineFinding> findings) {
        PrintWriter err = spec.commandLine().getErr();
        for (LineFinding finding : findings) {
            String severity = finding.severity() == Severity.ERROR ? "error" : "warning";
            err.println(file + ":" + finding.line() + ": " + severity + ": " + finding.message());
        }
        err.flush();
    }
}
