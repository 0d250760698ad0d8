package org.sami.crw.cli.record;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.sami.crw.cli.legacy.ImportReport;
import org.sami.crw.cli.legacy.ImportedProjectFile;
import org.sami.crw.cli.legacy.PlanTrial;
import org.sami.crw.cli.legacy.PlanTrials;
import org.sami.crw.cli.legacy.TrialReport;
import org.sami.crw.cli.legacy.TrialSettings;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.sim.run.RunObserver;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.legacy.LegacyTable;
import org.sami.spn.legacy.LegacyTableReader;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw import-legacy}: projects of the earlier system become projects of this one. */
@Command(
        name = "import-legacy",
        mixinStandardHelpOptions = true,
        description =
                "Imports a project of the earlier system from its neutral export (sami-legacy-project, version 1), "
                        + "counts the imported elements and names the missing ones.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:imported; findings list what was changed on import, and faults of the plans",
            "1:the export has errors: nothing is written",
            "2:wrong usage, FILE cannot be read, or OUT is there already",
            "4:with --run: an engine error, a livelock, an event that nothing handles, or stopped before all had run"
        },
        footerHeading = "%nExamples:%n",
        footer = {"  crw import-legacy thesis.json fleet.json", "  crw import-legacy thesis.json fleet --run --json"})
public final class ImportLegacyCommand implements Callable<Integer> {
    static final String TABLE = "/org/sami/domain/crw/legacy.json";

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(index = "0", paramLabel = "FILE", description = "The export.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private Path file;

    @Parameters(
            index = "1",
            paramLabel = "OUT",
            description = "The project to write: a file where the name ends in .json, else a folder. "
                    + "It must not be there yet.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private Path out;

    @Option(
            names = "--run",
            description =
                    "Then run every root plan that has a start place, each alone: 3 simulated boats, the simulated "
                            + "operator, and interrupts pressed at random, for one simulated hour.")
    private boolean run;

    @Option(
            names = "--seed",
            paramLabel = "S",
            defaultValue = "1",
            description = "Seed of the random numbers; equal seeds give equal runs (default ${DEFAULT-VALUE}).")
    private long seed;

    @Option(names = "--all", description = "Print each finding of the import in a line of its own as well.")
    private boolean all;

    @Option(names = "--json", description = "Print one JSON object on standard output, and nothing else there.")
    private boolean json;

    @Override
    public Integer call() throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new UsageFault("there is no file '" + file + "'");
        }
        BoundedFile.check(file, BoundedFile.PROJECT_BYTES);
        ImportedProjectFile target = new ImportedProjectFile(out);
        target.refusal().ifPresent(why -> {
            throw new UsageFault(why);
        });
        DomainLibrary library = PlanSource.library();
        Vocabulary vocabulary = library.vocabulary();
        LegacyTable table = LegacyTableReader.fromClassPath(TABLE, vocabulary).orThrow();
        LegacyImport.Result result = BoundedFile.making(file, () -> new LegacyImport(vocabulary, table).read(file));
        if (result.project().isPresent()) {
            target.write(result.project().get(), vocabulary);
        }
        PrintWriter writer = spec.commandLine().getOut();
        ImportReport imported = new ImportReport(String.valueOf(file), String.valueOf(out), result, Optional.empty());
        if (!json) {
            if (all) {
                FindingsText.print(writer, String.valueOf(file), result.findings());
            }
            writer.print(imported.text());
            writer.flush();
        }
        if (run && result.project().isPresent()) {
            return tried(result.project().get(), imported, vocabulary);
        }
        if (json) {
            writer.println(imported.json().toPrettyString());
            writer.flush();
        }
        return result.project().isPresent() ? ExitCode.OK : ExitCode.FINDINGS;
    }

    /** Tries the plans and prints what came of it; after Ctrl-C as well, of those that had run until then. */
    private int tried(Project project, ImportReport imported, Vocabulary vocabulary) {
        PrintWriter writer = spec.commandLine().getOut();
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            TrialReport trials = trials(project, imported.result().roots(), vocabulary, stop);
            writer.print(json ? imported.with(trials).json().toPrettyString() + System.lineSeparator() : trials.text());
            writer.flush();
            return trials.isSound() ? ExitCode.OK : ExitCode.FAILED;
        }
    }

    private TrialReport trials(Project project, List<String> roots, Vocabulary vocabulary, StopOnInterrupt stop) {
        PrintWriter err = spec.commandLine().getErr();
        PlanTrials trials = new PlanTrials(vocabulary, project, TrialSettings.of(seed));
        Map<String, String> servers = trials.boatOfServer();
        if (!json) {
            spec.commandLine().getOut().print(ImportReport.servers(servers));
            spec.commandLine().getOut().flush();
        }
        List<PlanTrial> done = new ArrayList<>();
        ProgressDisplay progress = new ProgressDisplay(err, Terminal.onStandardError(), System::nanoTime);
        for (String root : roots) {
            Plan plan = project.plan(root).orElseThrow();
            err.printf("plan %d of %d: %s%n", done.size() + 1, roots.size(), plan.title());
            err.flush();
            PlanTrial trial = trials.run(plan, new RunObserver(progress, stop));
            progress.end();
            if (stop.getAsBoolean()) {
                err.println("stopped");
                err.flush();
                break;
            }
            done.add(trial);
        }
        return new TrialReport(servers, done, roots.size());
    }
}
