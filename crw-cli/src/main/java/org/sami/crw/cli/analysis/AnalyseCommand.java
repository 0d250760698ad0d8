package org.sami.crw.cli.analysis;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.DepthOption;
import org.sami.crw.cli.option.DomainOption;
import org.sami.crw.cli.option.PlanOption;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.net.PetriNet;
import org.sami.petri.pnml.PnmlReading;
import org.sami.petri.pnml.PnmlWriter;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw analyse}: which markings a plan or a Petri net can reach. */
@Command(
        name = "analyse",
        mixinStandardHelpOptions = true,
        description =
                "Searches the reachable markings of a plan with its boats, or of a Petri net, and answers questions"
                        + " about them by proof or by a run that shows it.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:done; no fault is certain. What only the net of a plan does is printed as not certain",
            "1:the file has errors, or it is certain that a query has found a fault: a broken invariant, a deadlock, a"
                    + " run that cannot come home; or a plan's saved query has another answer than expected",
            "2:wrong usage, a query that makes no sense, or there is no such file",
            "5:the budget was used up before all was known"
        },
        footerHeading = "%nQueries:%n",
        footer = {
            "  reachable CONDITION          is there such a marking?",
            "  invariant CONDITION          are all markings such?",
            "  home CONDITION               can every run still come to such a marking?",
            "  deadlock [unless CONDITION]  is there a marking without an enabled transition, and not such?",
            "  bound PLACE                  how many tokens does a place have at most?",
            "A CONDITION compares tokens, m(PLACE), and has and, or, not, brackets, enabled(TRANSITION), deadlock.",
            "",
            "Examples:",
            "  crw analyse clv --boats 3",
            "  crw analyse clv --query 'reachable m(execute.robots) >= 2'",
            "  crw analyse line.pnml",
            "  crw analyse line.pnml --query 'invariant m(gate) + m(inside) = 1' --query deadlock",
            "  crw analyse kanban-4 --query 'reachable m(out4) >= 2 and m(kanban1) = 0'",
            "  crw analyse producer-consumer-0 --structure",
            "  crw analyse philosophers-8 --write philosophers-8.pnml"
        })
public final class AnalyseCommand implements Callable<Integer> {
    private static final String BOATS = "--boats";
    private static final List<String> ONLY_PLANS = List.of(BOATS, "--depth", "--plan", "--domain");
    private static final List<String> ONLY_NETS = List.of("--structure", "--symmetry", "--no-reduction");

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(
            paramLabel = "FILE|PLAN|NET",
            description = "A project's file or folder, a plan of the library by its id, a PNML file, or an example net"
                    + " by its name, such as kanban-5.")
    private String name = "";

    @Mixin
    private DomainOption domain = new DomainOption();

    @Mixin
    private PlanOption planOption = new PlanOption();

    @Option(
            names = BOATS,
            paramLabel = "N",
            defaultValue = "2",
            description = "With a plan: how many boats there are at the start. Default: ${DEFAULT-VALUE}.")
    private int boats;

    @Mixin
    private DepthOption depth = new DepthOption();

    @Option(names = "--query", paramLabel = "QUERY", description = "Answer this query; may be given several times.")
    private List<String> queries = new ArrayList<>();

    @Mixin
    private SearchOptions options = new SearchOptions();

    @Option(
            names = "--structure",
            description = "Say what follows from the arcs alone: invariants, bounds, whether it never stops, and which"
                    + " places are unbounded.")
    private boolean structure;

    @Option(names = "--json", description = "Print one JSON object.")
    private boolean json;

    @Option(
            names = {"--write", "--pnml"},
            paramLabel = "FILE",
            description = "Only write the net, or the net of the plan, as PNML; search nothing.")
    private @Nullable Path file;

    @Override
    public Integer call() throws IOException {
        SearchBudget budget = options.budget();
        boolean isNet = PlanArgument.isNet(name);
        refuse(isNet ? ONLY_PLANS : ONLY_NETS, isNet);
        return isNet ? analyseNet(budget) : analysePlan(budget);
    }

    private void refuse(List<String> others, boolean isNet) {
        for (String option : others) {
            if (spec.commandLine().getParseResult().hasMatchedOption(option)) {
                throw new UsageFault(
                        isNet
                                ? option + " is for plans; " + name + " is a net"
                                : option + " is for nets; --pnml FILE writes the net of a plan");
            }
        }
    }

    private PrintWriter err() {
        return spec.commandLine().getErr();
    }

    /** The budget of several searches, as far as the heap has room. */
    private SearchBudget fitted(SearchBudget budget) {
        return HeapRoom.fitted(budget, true, err());
    }

    private int analysePlan(SearchBudget budget) throws IOException {
        Optional<PlanArgument> plan =
                PlanArgument.read(name, domain, planOption.name(), boats, depth.levels(), file != null, err());
        if (plan.isEmpty()) {
            return ExitCode.FINDINGS;
        }
        if (file != null) {
            return write(plan.get().net().net(), file);
        }
        ProgressDisplay progress = new ProgressDisplay(err(), Terminal.onStandardError(), System::nanoTime);
        PlanAnalysis analysis;
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            analysis = PlanAnalysis.of(
                    plan.get(), queries, fitted(budget), options.asksStructure(), SearchProgress.watch(progress, stop));
            progress.end();
        }
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(PlanAnalysisJson.of(name, analysis).toPrettyString());
        } else {
            new PlanAnalysisText(out, analysis).print();
        }
        out.flush();
        return analysis.hasFound() ? ExitCode.FINDINGS : analysis.isOpen() ? ExitCode.RUNNING : ExitCode.OK;
    }

    private int analyseNet(SearchBudget budget) throws IOException {
        PnmlReading reading = NetArgument.read(name);
        PrintWriter out = spec.commandLine().getOut();
        if (file != null && reading.net().isPresent()) {
            NetArgument.print(err(), name, reading.findings());
            return write(reading.net().get(), file);
        }
        if (structure && !queries.isEmpty() && reading.net().isPresent()) {
            throw new UsageFault("--structure answers no --query; without it queries are answered");
        }
        NetReport report = new NetReport(name, reading, budget, options, json, out, err());
        int code = structure ? report.structure() : report.answers(queries);
        out.flush();
        return code;
    }

    private int write(PetriNet net, Path to) throws IOException {
        boolean isThere = Files.exists(to);
        if (to.getParent() != null) {
            Files.createDirectories(to.getParent());
        }
        try (OutputStream out = Files.newOutputStream(to)) {
            PnmlWriter.write(net, out);
        }
        PrintWriter out = spec.commandLine().getOut();
        out.println((isThere ? "replaced " : "written to ") + to);
        out.flush();
        return ExitCode.OK;
    }
}
