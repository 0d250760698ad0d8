package org.sami.crw.cli.analysis;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.sami.crw.cli.option.DepthOption;
import org.sami.crw.cli.option.DomainOption;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.option.SecondsConverter;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.petri.graph.SearchBudget;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Plan;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw analyse-all}: a table of what many plans can reach with several numbers of boats. */
@Command(
        name = "analyse-all",
        mixinStandardHelpOptions = true,
        description =
                "Searches all plans of files, or of the library, with several numbers of boats. A table says whether"
                        + " each plan stops before its end, whether every run can end, and how its queries are answered.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:done; no fault is certain",
            "1:a file has errors, or it is certain that a plan stops before its end, that a run cannot end, or that a"
                    + " saved query has another answer than expected",
            "2:wrong usage, or there is no such file",
            "5:a search ended before all was known"
        },
        footerHeading = "%nExamples:%n",
        footer = {"  crw analyse-all", "  crw analyse-all my-plan.json --boats 1,2,8", "  crw analyse-all --depth 1"})
public final class AnalyseAllCommand implements Callable<Integer> {
    private static final int STANDARD_STATES = 50_000;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(
            arity = "0..*",
            paramLabel = "FILE|PLAN",
            description = "Projects' files or folders, or plans of the library by their ids; without them all plans of"
                    + " the library.")
    private List<String> names = new ArrayList<>();

    @Mixin
    private DomainOption domain = new DomainOption();

    @Option(
            names = "--boats",
            paramLabel = "N,...",
            split = ",",
            defaultValue = "1,3,5",
            description = "How many boats there are at the start. Default: ${DEFAULT-VALUE}.")
    private List<Integer> boats = new ArrayList<>();

    @Mixin
    private DepthOption depth = new DepthOption();

    @Option(
            names = "--time",
            paramLabel = "SECONDS",
            defaultValue = "60",
            converter = SecondsConverter.class,
            description = "How long each search may take. Default: ${DEFAULT-VALUE}.")
    private long millis;

    @Option(
            names = "--states",
            paramLabel = "N",
            defaultValue = "0",
            description = "How many states of a net are looked at; 0: 50000, fewer in nets of more than 300"
                    + " transitions, and none of those with more than 10000.")
    private int states;

    @Override
    public Integer call() {
        if (boats.stream().anyMatch(n -> n < 0 || n > PlanArgument.MOST_BOATS)) {
            throw new UsageFault("--boats is 0 to " + PlanArgument.MOST_BOATS + ", several with commas, not " + boats);
        }
        if (states < 0 || states > SearchBudget.MOST_STATES) {
            throw new UsageFault("--states is 0 to " + SearchBudget.MOST_STATES + ", not " + states);
        }
        int levels = depth.levels();
        Reading<DomainLibrary> words = domain.read();
        PrintWriter err = spec.commandLine().getErr();
        if (words.result().isEmpty()) {
            FindingsText.print(err, domain.name(), words.findings());
            return ExitCode.FINDINGS;
        }
        DomainLibrary library = words.result().get();
        List<PlanSource> sources = names.isEmpty()
                ? List.of(PlanSource.all(library))
                : names.stream().map(name -> domain.find(name, library)).toList();
        PrintWriter out = spec.commandLine().getOut();
        AnalysisTable table = new AnalysisTable(out);
        table.begin();
        boolean isRead = true;
        ProgressDisplay progress = new ProgressDisplay(err, Terminal.onStandardError(), System::nanoTime);
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            SearchBudget budget = new SearchBudget(
                    states > 0 ? states : STANDARD_STATES,
                    Runtime.getRuntime().maxMemory() / 2,
                    Duration.ofMillis(millis));
            AnalysedPlans analysed =
                    new AnalysedPlans(library, budget, states == 0, levels, SearchProgress.watch(progress, stop));
            for (PlanSource source : sources) {
                isRead &= source.project().isPresent();
                if (source.project().isEmpty()) {
                    FindingsText.print(err, source.source(), source.findings());
                }
                for (Plan plan : plans(source)) {
                    List<Finding> errors = source.concerning(List.of(plan)).stream()
                            .filter(Finding::isError)
                            .toList();
                    FindingsText.print(err, source.source(), errors);
                    isRead &= errors.isEmpty();
                    if (errors.isEmpty()) {
                        boats.forEach(
                                n -> table.add(analysed.row(source.project().orElseThrow(), plan, n)));
                    }
                }
            }
            progress.end();
        }
        table.end();
        out.flush();
        return isRead ? table.exitCode() : ExitCode.FINDINGS;
    }

    /** The plans that are meant: the named one, or all that have a start. */
    private static List<Plan> plans(PlanSource source) {
        return Optional.of(source)
                .flatMap(PlanSource::plan)
                .map(List::of)
                .orElseGet(() -> source.project().stream()
                        .flatMap(project -> project.plans().stream())
                        .filter(plan -> plan.startPlace().isPresent())
                        .toList());
    }
}
