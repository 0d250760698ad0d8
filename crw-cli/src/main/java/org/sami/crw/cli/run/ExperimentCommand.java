package org.sami.crw.cli.run;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.ConditionsConverter;
import org.sami.crw.cli.option.DomainOption;
import org.sami.crw.cli.option.PlanOption;
import org.sami.crw.cli.option.ScenarioOptions;
import org.sami.crw.cli.option.SeedsConverter;
import org.sami.crw.cli.option.WorkersOption;
import org.sami.crw.cli.output.ErrorMessages;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.sim.experiment.Experiment;
import org.sami.crw.sim.experiment.ExperimentCase;
import org.sami.crw.sim.experiment.ExperimentRow;
import org.sami.crw.sim.experiment.ExperimentTable;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.spn.json.DomainLibrary;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw experiment}: one or several missions with many seeds, in several conditions. */
@Command(
        name = "experiment",
        preprocessor = TableArguments.class,
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description = "Runs missions on simulated boats with many seeds and in several conditions, side by side on all"
                + " cores, and prints a table of the results. Equal experiments give equal tables. The tables of the"
                + " thesis, and experiments of your own that compare versions of a mission, have other options: see 'crw"
                + " experiment --table all --help'.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:all missions ended",
            "1:a plan or an answers file has errors; nothing was run",
            "2:wrong usage, or a file that cannot be read",
            "3:a mission was aborted; none failed",
            "4:a mission or the program failed",
            "5:a mission was still running at its time (--for), or not all were run (Ctrl-C); none failed or was"
                    + " aborted",
            "6:all missions ended, some with problems, or with a boat deeper in an avoided area than announced"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw experiment clv --boats 5 --locations 20",
            "  crw experiment explore-area --seeds 1..50 --conditions field --out explore.csv",
            "  crw experiment --runs library.runs --seeds 1..20",
            "  crw experiment --table 7.2 --repetitions 10 --out table-7.2"
        })
public final class ExperimentCommand implements Callable<Integer>, TableArguments.Receiver {
    private static final String RUNS = "--runs";
    private static final Set<String> OF_THE_EXPERIMENT =
            Set.of(RUNS, "--seeds", "--conditions", "--jobs", "--out", "--overwrite", "--workers");

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(
            paramLabel = "PLAN|FILE",
            arity = "0..1",
            description = "A plan of the library by its id (see 'crw plans'), or a project's file or folder.")
    private @Nullable String name;

    @Option(
            names = "--seeds",
            paramLabel = "FROM..TO",
            defaultValue = "1..20",
            converter = SeedsConverter.class,
            description = "The seeds of the runs, such as 1..20 or 3,7,11..13 (default ${DEFAULT-VALUE}).")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private SeedsConverter.Seeds seeds;

    @Option(
            names = "--conditions",
            paramLabel = "NAME,...",
            split = ",",
            defaultValue = "calm,field,rough",
            converter = ConditionsConverter.class,
            description = "The conditions of the runs: calm, field, rough (default: ${DEFAULT-VALUE}).")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private List<NamedConditions> conditions;

    @Option(
            names = RUNS,
            paramLabel = "FILE",
            description = "Instead of PLAN: a file with a mission a line, a plan and options of 'crw run'.")
    private @Nullable Path runs;

    @Option(
            names = "--jobs",
            paramLabel = "N",
            description = "How many runs go side by side (default: as many as there are cores).")
    private @Nullable Integer jobs;

    @Option(names = "--out", paramLabel = "FILE", description = "Write a table with a row for each run there (CSV).")
    private @Nullable Path out;

    @Option(names = "--overwrite", description = "Replace the file of --out where there is one.")
    private boolean overwrite;

    @Mixin
    private WorkersOption workers = new WorkersOption();

    @Mixin
    private DomainOption domain = new DomainOption();

    @Mixin
    private PlanOption planOption = new PlanOption();

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private ScenarioOptions options;

    private List<String> tableArguments = List.of();

    @Override
    public void makeTable(List<String> arguments) {
        tableArguments = List.copyOf(arguments);
    }

    private int callTable() {
        CommandLine line = new CommandLine(new ExperimentTableCommand());
        line.setOut(spec.commandLine().getOut());
        line.setErr(spec.commandLine().getErr());
        line.setParameterExceptionHandler(ErrorMessages::onWrongUsage);
        line.setExecutionExceptionHandler(ErrorMessages::onException);
        return line.execute(tableArguments.toArray(new String[0]));
    }

    @Override
    public Integer call() throws IOException {
        if (!tableArguments.isEmpty()) {
            return callTable();
        }
        PrintWriter err = spec.commandLine().getErr();
        int threads = threads();
        Optional<DomainLibrary> words = domain.library(err);
        if (words.isEmpty()) {
            return ExitCode.FINDINGS;
        }
        List<ExperimentCase> cases;
        try {
            cases = cases(words.get());
        } catch (ExperimentRuns.FaultyFile faulty) {
            FindingsText.print(err, faulty.source(), faulty.findings());
            err.flush();
            return ExitCode.FINDINGS;
        }
        checkOut();
        Map<String, Conditions> waters = new LinkedHashMap<>();
        conditions.forEach(named -> waters.put(named.toString(), named.conditions()));
        Experiment experiment = new Experiment(cases, waters, seeds.all());
        err.printf(
                "%d runs: missions %d, conditions %d, seeds %d; %d at a time%n",
                experiment.size(), cases.size(), waters.size(), seeds.all().size(), threads);
        err.flush();
        return run(
                experiment,
                (stop, progress) -> workers.address().isEmpty()
                        ? experiment.run(
                                threads, stop, done -> progress.show(() -> done + " of " + experiment.size() + " runs"))
                        : new SharedExperiment(workers.address().get(), "runs", err)
                                .rows(
                                        "missions",
                                        experiment.portions(),
                                        ExperimentSettings.of(
                                                cases, List.copyOf(waters.keySet()), seeds.all(), words.get()),
                                        threads,
                                        stop));
    }

    private int threads() {
        if (jobs == null) {
            return Runtime.getRuntime().availableProcessors();
        }
        UsageFault.unlessWithin("--jobs", jobs, 1, 1000);
        return jobs;
    }

    private List<ExperimentCase> cases(DomainLibrary library) throws ExperimentRuns.FaultyFile {
        ExperimentRuns read = new ExperimentRuns(library);
        if (runs == null && name == null && !options.hasScript()) {
            throw new UsageFault("which missions? Name a plan (PLAN|FILE), or a file with a mission a line (--runs)");
        }
        if (runs == null) {
            return List.of(read.of(name, planOption.name(), "", options, Path.of("")));
        }
        if (name != null) {
            throw new UsageFault("--runs: the missions are those of " + runs + ", and '" + name + "' is too many");
        }
        for (OptionSpec given : spec.commandLine().getParseResult().matchedOptions()) {
            boolean isOfAMission = !given.inherited() && !OF_THE_EXPERIMENT.contains(given.longestName());
            if (isOfAMission) {
                throw new UsageFault(
                        given.longestName() + ": with --runs each line of " + runs + " has its own options");
            }
        }
        return read.read(runs);
    }

    private void checkOut() {
        if (out == null) {
            if (overwrite) {
                throw new UsageFault("--overwrite: there is no --out whose file it could be about");
            }
            return;
        }
        Path folder = out.toAbsolutePath().getParent();
        if (folder == null || !Files.isDirectory(folder) || !Files.isWritable(folder) || Files.isDirectory(out)) {
            throw new UsageFault("--out: " + out + " cannot be written");
        }
        if (Files.exists(out) && !overwrite) {
            throw new UsageFault(
                    "--out: " + out + " is there already; choose another file, or replace it with --overwrite");
        }
    }

    /** Makes the rows of an experiment, here or with other machines. */
    private interface Making {
        List<ExperimentRow> rows(StopOnInterrupt stop, ProgressDisplay progress) throws IOException;
    }

    private int run(Experiment experiment, Making making) throws IOException {
        PrintWriter err = spec.commandLine().getErr();
        ProgressDisplay progress = new ProgressDisplay(err, Terminal.onStandardError(), System::nanoTime);
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            List<ExperimentRow> rows = making.rows(stop, progress);
            progress.end();
            boolean stopped = Thread.interrupted() || rows.size() < experiment.size();
            spec.commandLine().getOut().print(ExperimentTable.text(rows));
            spec.commandLine().getOut().flush();
            boolean written = write(rows);
            long ended = rows.stream()
                    .filter(row -> row.ending().outcome() == RunOutcome.ENDED)
                    .count();
            err.println(
                    stopped
                            ? "stopped: of " + experiment.size() + " runs " + rows.size() + " were made, and " + ended
                                    + " ended"
                            : ended + " of " + rows.size() + " runs ended");
            err.flush();
            int code = exitCode(rows, stopped);
            return written || code != ExitCode.OK ? code : ExitCode.FAILED;
        }
    }

    private boolean write(List<ExperimentRow> rows) {
        if (out == null) {
            return true;
        }
        try {
            Files.writeString(out, ExperimentTable.csv(rows));
            return true;
        } catch (IOException e) {
            PrintWriter err = spec.commandLine().getErr();
            err.println("crw: the table could not be written to " + out + ": " + ErrorMessages.words(e));
            err.flush();
            return false;
        }
    }

    /** The gravest of the runs' exit codes: failed, aborted, running, with problems. */
    private static int exitCode(List<ExperimentRow> rows, boolean stopped) {
        List<RunOutcome> outcomes =
                new ArrayList<>(rows.stream().map(row -> row.ending().outcome()).toList());
        if (stopped) {
            outcomes.add(RunOutcome.RUNNING);
        }
        for (RunOutcome grave : List.of(RunOutcome.FAILED, RunOutcome.ABORTED, RunOutcome.RUNNING)) {
            if (outcomes.contains(grave)) {
                return ExitCode.of(grave);
            }
        }
        return rows.stream().allMatch(ExperimentRow::isGreen) ? ExitCode.OK : ExitCode.PROBLEMS;
    }
}
