package org.sami.crw.cli.analysis;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
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
import org.sami.crw.cli.option.DomainOption;
import org.sami.crw.cli.option.PlanOption;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.net.PetriNet;
import org.sami.petri.pnml.PnmlReading;
import org.sami.petri.pnml.PnmlWriter;
import org.sami.petri.query.NetQuery;
import org.sami.petri.query.QueryFaultException;
import org.sami.petri.query.QueryMeans;
import org.sami.petri.query.QueryParser;
import org.sami.petri.query.QueryRunner;
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
    private static final List<String> ONLY_PLANS = List.of(BOATS, "--plan", "--domain");
    private static final List<String> ONLY_NETS = List.of("--structure", "--symmetry", "--no-reduction", "--search");

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

    private int analysePlan(SearchBudget budget) throws IOException {
        Optional<PlanArgument> plan = PlanArgument.read(
                name,
                domain,
                planOption.name(),
                boats,
                file != null,
                spec.commandLine().getErr());
        if (plan.isEmpty()) {
            return ExitCode.FINDINGS;
        }
        if (file != null) {
            return write(plan.get().net().net(), file);
        }
        ProgressDisplay progress =
                new ProgressDisplay(spec.commandLine().getErr(), Terminal.onStandardError(), System::nanoTime);
        PlanAnalysis analysis;
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            analysis = PlanAnalysis.of(plan.get(), queries, budget, SearchProgress.watch(progress, stop));
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
        Optional<PetriNet> net = reading.net();
        if (net.isEmpty()) {
            if (json) {
                out.println(AnalysisJson.of(name, reading.findings()).toPrettyString());
            } else {
                NetArgument.print(out, name, reading.findings());
            }
            out.flush();
            return ExitCode.FINDINGS;
        }
        if (file != null) {
            NetArgument.print(spec.commandLine().getErr(), name, reading.findings());
            return write(net.get(), file);
        }
        if (structure) {
            return structure(net.get(), reading, budget);
        }
        List<NetQuery> asked = parsed(net.get());
        if (!json) {
            NetArgument.print(out, name, reading.findings());
            out.println(net.get());
        }
        List<NetAnalysis> analyses = analyses(net.get(), asked, budget);
        print(out, reading, analyses);
        out.flush();
        if (analyses.stream().anyMatch(NetAnalysis::hasFound)) {
            return ExitCode.FINDINGS;
        }
        return analyses.stream().anyMatch(NetAnalysis::isOpen) ? ExitCode.RUNNING : ExitCode.OK;
    }

    private int structure(PetriNet net, PnmlReading reading, SearchBudget budget) {
        if (!queries.isEmpty()) {
            throw new UsageFault("--structure answers no --query; without it queries are answered");
        }
        PrintWriter out = spec.commandLine().getOut();
        ProgressDisplay progress =
                new ProgressDisplay(spec.commandLine().getErr(), Terminal.onStandardError(), System::nanoTime);
        StructureFacts facts;
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            facts = StructureFacts.of(net, budget, SearchProgress.watch(progress, stop), stop);
            progress.end();
        }
        if (json) {
            ObjectNode object = AnalysisJson.of(name, reading.findings());
            StructureJson.put(object, facts);
            out.println(object.toPrettyString());
        } else {
            NetArgument.print(out, name, reading.findings());
            out.println(net);
            new StructureText(out, facts).print();
        }
        out.flush();
        return facts.isOpen() ? ExitCode.RUNNING : ExitCode.OK;
    }

    private List<NetQuery> parsed(PetriNet net) {
        List<NetQuery> parsed = new ArrayList<>();
        for (String query : queries) {
            try {
                parsed.add(QueryParser.query(net, query));
            } catch (QueryFaultException fault) {
                throw new UsageFault("--query '" + query + "', " + fault.words());
            }
        }
        return parsed;
    }

    private List<NetAnalysis> analyses(PetriNet net, List<NetQuery> asked, SearchBudget budget) {
        ProgressDisplay progress =
                new ProgressDisplay(spec.commandLine().getErr(), Terminal.onStandardError(), System::nanoTime);
        List<NetAnalysis> analyses = new ArrayList<>();
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            GraphWatch watch = SearchProgress.watch(progress, stop);
            QueryMeans means = options.means(net);
            if (asked.isEmpty()) {
                SearchSettings whole = SearchSettings.within(budget);
                analyses.add(NetAnalysis.of(ReachabilitySearch.explore(
                        net, means.symmetry().map(whole::withSymmetry).orElse(whole), watch, System::nanoTime)));
            }
            QueryRunner runner = new QueryRunner(net, budget, means, watch, System::nanoTime);
            ProofsBeforeSearch proofs = new ProofsBeforeSearch(net, budget, watch, stop);
            for (int i = 0; i < asked.size(); i++) {
                NetQuery query = asked.get(i);
                String text = queries.get(i);
                Optional<NetAnalysis> proved = options.asksStructure() ? proofs.answer(text, query) : Optional.empty();
                analyses.add(proved.orElseGet(() -> NetAnalysis.of(text, query, runner.answer(query))));
            }
            progress.end();
        }
        return analyses;
    }

    /** Without queries, the members of the whole graph stand in the object itself; else there is an object for each query. */
    private void print(PrintWriter out, PnmlReading reading, List<NetAnalysis> analyses) {
        if (!json) {
            analyses.forEach(analysis -> new AnalysisText(out, analysis).print());
            return;
        }
        ObjectNode object = AnalysisJson.of(name, reading.findings());
        if (queries.isEmpty()) {
            AnalysisJson.put(object, analyses.get(0));
        } else {
            ArrayNode list = object.putArray("queries");
            analyses.forEach(analysis -> AnalysisJson.put(list.addObject(), analysis));
        }
        out.println(object.toPrettyString());
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
