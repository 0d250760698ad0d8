package org.sami.crw.cli.run;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.Converters;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.option.ScenarioOptions;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.console.CommandLineText;
import org.sami.crw.console.ConsoleFault;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.sim.experiment.ExperimentCase;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Speed;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.FileTooLargeException;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Plan;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;

/** Makes the cases of an experiment, of the command's own options or of a file with a run a line. */
public final class ExperimentRuns {
    private final DomainLibrary library;

    /** A plan or an answers file has errors. */
    static final class FaultyFile extends Exception {
        private static final long serialVersionUID = 1;

        private final transient String source;
        private final transient List<Finding> findings;

        FaultyFile(String source, List<Finding> findings) {
            super(source + " has errors");
            this.source = source;
            this.findings = findings;
        }

        /** The file as it was named. */
        String source() {
            return source;
        }

        /** What is wrong with it. */
        List<Finding> findings() {
            return findings;
        }
    }

    /** What stands in a line. */
    @Command(name = "a run")
    static final class Line {
        @Parameters(paramLabel = "PLAN|FILE", arity = "0..1")
        private @Nullable String name; // null where a script stands in its place

        @Option(names = "--plan", defaultValue = "")
        @SuppressWarnings("NullAway.Init") // picocli sets it
        private String plan;

        @Option(names = "--label", defaultValue = "")
        @SuppressWarnings("NullAway.Init") // picocli sets it
        private String label;

        @Mixin
        @SuppressWarnings("NullAway.Init") // picocli sets it
        private ScenarioOptions options;
    }

    /** Cases with plans of a library, or of files. */
    public ExperimentRuns(DomainLibrary library) {
        this.library = library;
    }

    /**
     * The cases of a file. A line has a plan and options of {@code crw run}; files that it names are relative to its folder.
     *
     * @throws UsageFault that begins with the line where one makes no sense
     */
    public List<ExperimentCase> read(Path file) throws FaultyFile {
        Map<String, Integer> lineOf = new LinkedHashMap<>();
        List<ExperimentCase> cases = new ArrayList<>();
        List<String> lines = lines(file);
        for (int i = 0; i < lines.size(); i++) {
            try {
                List<String> words = CommandLineText.words(lines.get(i));
                if (words.isEmpty()) {
                    continue;
                }
                ExperimentCase read = read(words, file.toAbsolutePath().resolveSibling(""));
                Integer earlier = lineOf.putIfAbsent(read.label(), i + 1);
                if (earlier != null) {
                    throw new UsageFault("line " + earlier + " is called '" + read.label()
                            + "' already; give one of the two another name with --label");
                }
                cases.add(read);
            } catch (UsageFault | ConsoleFault | ParameterException fault) {
                throw new UsageFault(file + ":" + (i + 1) + ": " + fault.getMessage());
            }
        }
        if (cases.isEmpty()) {
            throw new UsageFault("--runs: there is no run in " + file);
        }
        return cases;
    }

    private static List<String> lines(Path file) {
        try {
            return BoundedFile.text(file, BoundedFile.DATA_BYTES).lines().toList();
        } catch (FileTooLargeException e) {
            throw new UsageFault("--runs: " + e.getMessage());
        } catch (IOException e) {
            throw new UsageFault("--runs: cannot read " + file);
        }
    }

    private ExperimentCase read(List<String> words, Path folder) throws FaultyFile {
        Line line = new Line();
        Converters.addTo(new CommandLine(line)).parseArgs(words.toArray(String[]::new));
        boolean isFile = line.name != null && Files.exists(folder.resolve(line.name));
        return of(
                isFile ? folder.resolve(line.name).toString() : line.name, line.plan, line.label, line.options, folder);
    }

    /**
     * A case.
     *
     * @param name of a plan of the library, or of a file; null where the options have a script
     * @param planName empty text where the user did not say
     * @param label likewise; it is the plan's id then
     * @param folder that the answers file and the script are looked for in
     */
    ExperimentCase of(@Nullable String name, String planName, String label, ScenarioOptions options, Path folder)
            throws FaultyFile {
        PlanSource source = options.source(name, library);
        if (source.project().isEmpty()) {
            throw new FaultyFile(source.source(), source.findings());
        }
        List<Plan> plans = options.plans(source, planName, library.vocabulary(), folder);
        Plan plan = plans.get(0);
        List<Finding> concerning = source.concerning(plans);
        if (concerning.stream().anyMatch(Finding::isError)) {
            throw new FaultyFile(source.source(), concerning);
        }
        ScenarioOptions.Rest rest = new ScenarioOptions.Rest(1, Conditions.CALM, Speed.MAX, List.of());
        RunSettings given = options.settings(plan.id(), plan.title(), rest, folder);
        RunSettings settings = options.withRobots(given, HandlerModules.robotsOf(library.vocabulary()));
        Reading<AnswersFile> answers = Execution.answers(settings, library.vocabulary());
        if (answers.hasErrors()) {
            throw new FaultyFile(options.answersFile(), answers.findings());
        }
        RunPlan runPlan = new RunPlan(library.vocabulary(), source.project().get(), plan);
        options.checkScript(runPlan, settings, folder);
        Execution.checkSettings(runPlan, settings);
        return new ExperimentCase(label.isEmpty() ? plan.id() : label, runPlan, settings, answers.orThrow());
    }
}
