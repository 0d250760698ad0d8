package org.sami.crw.cli.run;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.option.WorkersOption;
import org.sami.crw.cli.output.ErrorMessages;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.sim.experiment.table.ExperimentFile;
import org.sami.crw.sim.experiment.table.ExperimentFileReader;
import org.sami.crw.sim.experiment.table.ScenarioVariables;
import org.sami.crw.sim.experiment.table.ThesisTables;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.FileTooLargeException;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.work.postgres.WorkException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw experiment --table} and {@code crw experiment FILE} of an experiment's file: compares versions of a mission in configurations. */
@Command(
        name = "crw experiment",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description =
                "Compares versions of a mission, such as with an interrupt and without, in configurations with equal"
                        + " locations, batteries and incidents, and prints the table: a table of the thesis, or an"
                        + " experiment's file. Equal experiments give equal tables.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:every repetition counts",
            "1:the file has errors; nothing was run",
            "2:wrong usage, or a file that cannot be read",
            "4:the program failed",
            "5:not all runs were made (Ctrl-C); with --out the next call goes on",
            "6:some repetitions failed: a version did not end, or missed a location"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw experiment --table 7.2 --repetitions 2",
            "  crw experiment --table all --out tables",
            "  crw experiment --table 7.2 --sensitivity --repetitions 3",
            "  crw experiment my-experiment.json --boats 3,5,8 --conditions field"
        })
final class ExperimentTableCommand implements Callable<Integer> {
    private static final String ALL = "all";
    private static final int MOST_REPETITIONS = 100_000;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(paramLabel = "FILE", arity = "0..1", description = "An experiment's file (docs/experiments.md).")
    private @Nullable Path file;

    @Option(
            names = "--table",
            paramLabel = "NUMBER",
            split = ",",
            description = "Tables of the thesis: 7.1, 7.2, 7.3, 7.4, 8.1, or all.")
    private List<String> tables = new ArrayList<>();

    @Option(
            names = "--repetitions",
            paramLabel = "N",
            defaultValue = "10",
            description = "Repetitions of each configuration (default ${DEFAULT-VALUE}).")
    private int repetitions;

    @Option(
            names = "--seed",
            paramLabel = "S",
            defaultValue = "1",
            description = "Seed of the first repetition; the next one has the next seed (default ${DEFAULT-VALUE}).")
    private long seed;

    @Option(names = "--boats", paramLabel = "N,...", description = "Numbers of boats.")
    private @Nullable String boats;

    @Option(names = "--locations", paramLabel = "N,...", description = "Numbers of locations.")
    private @Nullable String locations;

    @Option(names = "--area", paramLabel = "METRES,...", description = "Side of the square in which they lie.")
    private @Nullable String area;

    @Option(names = "--range", paramLabel = "METRES,...", description = "How far a full battery takes a boat.")
    private @Nullable String range;

    @Option(
            names = "--discharge-interval",
            paramLabel = "SECONDS,...",
            description = "For how long the cost of a metre stays the same for a boat.")
    private @Nullable String dischargeInterval;

    @Option(
            names = "--charge",
            paramLabel = "MIN..MAX,...",
            description = "Charges at the start, in percent, drawn for each boat.")
    private @Nullable String charge;

    @Option(names = "--answer-after", paramLabel = "SECONDS,...", description = "Delay of each answer of the operator.")
    private @Nullable String answerAfter;

    @Option(
            names = "--alarm-length",
            paramLabel = "SECONDS,...",
            description = "How long an alarm lasts once boats have assembled.")
    private @Nullable String alarmLength;

    @Option(names = "--conditions", paramLabel = "NAME,...", description = "Water and instruments: calm, field, rough.")
    private @Nullable String conditions;

    @Option(
            names = "--allocation",
            paramLabel = "CRITERION,...",
            description = "How all versions divide locations: auction, execution-time, execution-safety,"
                    + " execution-efficiency.")
    private @Nullable String allocation;

    @Option(names = "--sensor-rate", paramLabel = "HZ,...", description = "Readings of each boat a second.")
    private @Nullable String sensorRate;

    @Option(
            names = "--set",
            paramLabel = "NAME=VALUE[,VALUE...]",
            description = "Values of another setting or factor of the experiment. May be given several times.")
    private Map<String, String> others = new LinkedHashMap<>();

    @Option(
            names = "--sensitivity",
            description = "One factor at a time: a base with the first value of each factor, and for each further value"
                    + " of a factor, and of the experiment's sensitivity, a line that differs in that alone.")
    private boolean sensitivity;

    @Option(
            names = "--jobs",
            paramLabel = "N",
            description = "How many repetitions go side by side (default: as many as there are cores).")
    private @Nullable Integer jobs;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description =
                    "Write runs.csv, table.txt, table.csv, table.html and table.png there, with several tables in a"
                            + " folder each. Runs that are there already are not made again.")
    private @Nullable Path out;

    @Mixin
    private WorkersOption workers = new WorkersOption();

    @Option(names = "--overwrite", description = "Make all runs again, and replace what --out holds.")
    private boolean overwrite;

    @Override
    public Integer call() throws IOException {
        PrintWriter err = spec.commandLine().getErr();
        if (file == null == tables.isEmpty()) {
            throw new UsageFault("which experiment? Name tables (--table), or a file");
        }
        UsageFault.unlessWithin("--repetitions", repetitions, 1, MOST_REPETITIONS);
        if (jobs != null) {
            UsageFault.unlessWithin("--jobs", jobs, 1, 1000);
        }
        if (overwrite && out == null) {
            throw new UsageFault("--overwrite: there is no --out whose files it could be about");
        }
        if (overwrite && workers.address().isPresent()) {
            throw new UsageFault(
                    "--overwrite: runs that machines divide are kept in the database; to make them again name"
                            + " another schema in --workers");
        }
        DomainLibrary library = PlanSource.library();
        Project project = library.combined();
        Map<String, ExperimentFile> experiments = new LinkedHashMap<>();
        for (String name : file == null ? names() : List.of(file.toString())) {
            Reading<ExperimentFile> read = ExperimentFileReader.read(text(name), library.vocabulary(), project);
            List<Finding> findings = new ArrayList<>(read.findings());
            read.result().map(this::changed).ifPresent(changed -> {
                findings.addAll(ExperimentFileReader.check(changed, library.vocabulary(), project));
                experiments.put(name, changed);
            });
            if (!findings.isEmpty()) {
                FindingsText.print(err, name, findings);
                err.flush();
                return ExitCode.FINDINGS;
            }
        }
        return run(experiments, library, project);
    }

    private int run(Map<String, ExperimentFile> experiments, DomainLibrary library, Project project)
            throws WorkException {
        PrintWriter err = spec.commandLine().getErr();
        int threads = jobs == null ? Runtime.getRuntime().availableProcessors() : jobs;
        int worst = ExitCode.OK;
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            for (Map.Entry<String, ExperimentFile> one : experiments.entrySet()) {
                Path folder = out == null || experiments.size() == 1 ? out : out.resolve(one.getKey());
                Map<String, String> settings =
                        ExperimentSettings.of(one.getValue(), repetitions, seed, library, project);
                TableJob job = new TableJob(
                        one.getValue(),
                        library.vocabulary(),
                        project,
                        spec.commandLine().getOut(),
                        err,
                        workers.address().map(address -> new SharedTable(address, settings, err)));
                int code = job.run(repetitions, seed, threads, folder, overwrite, stop);
                worst = code == ExitCode.OK ? worst : code;
                if (code == ExitCode.RUNNING) {
                    break;
                }
            }
        } catch (WorkException database) {
            throw database;
        } catch (IOException e) {
            throw new UsageFault("--out: " + out + " cannot be written: " + ErrorMessages.words(e));
        }
        return worst;
    }

    private List<String> names() {
        for (String name : tables) {
            if (!name.equals(ALL) && !ThesisTables.NAMES.contains(name)) {
                throw new UsageFault("--table: there is no table '" + name + "'; there are "
                        + String.join(", ", ThesisTables.NAMES) + ", or all");
            }
        }
        return tables.contains(ALL) ? ThesisTables.NAMES : tables;
    }

    private String text(String name) {
        if (file == null) {
            return ThesisTables.text(name);
        }
        try {
            return BoundedFile.text(file, BoundedFile.DATA_BYTES);
        } catch (FileTooLargeException e) {
            throw new UsageFault(String.valueOf(e.getMessage()));
        } catch (IOException e) {
            throw new UsageFault("cannot read " + file);
        }
    }

    private ExperimentFile changed(ExperimentFile read) {
        Map<String, String> given = new LinkedHashMap<>();
        put(given, "boats", boats);
        put(given, "locations", locations);
        put(given, "area", area);
        put(given, "range", range);
        put(given, "discharge-interval", dischargeInterval);
        put(given, "charge", charge);
        put(given, "answer-after", answerAfter);
        put(given, "alarm-length", alarmLength);
        put(given, "conditions", conditions);
        put(given, "allocation", allocation);
        put(given, "sensor-rate", sensorRate);
        for (String name : others.keySet()) {
            if (!ScenarioVariables.USUAL.containsKey(name)
                    && !read.settings().containsKey(name)
                    && !read.factors().containsKey(name)) {
                throw new UsageFault("--set: the experiment has no '" + name + "'; it has "
                        + String.join(", ", read.factors().keySet()) + ", "
                        + String.join(", ", read.settings().keySet()));
            }
        }
        given.putAll(others);
        Map<String, List<String>> values = new LinkedHashMap<>();
        given.forEach((name, text) -> values.put(name, List.of(text.split(",", -1))));
        ExperimentFile with = read.with(values);
        return sensitivity ? with.oneFactorAtATime() : with;
    }

    private static void put(Map<String, String> given, String name, @Nullable String text) {
        if (text != null) {
            given.put(name, text);
        }
    }
}
