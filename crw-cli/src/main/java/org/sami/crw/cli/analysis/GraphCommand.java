package org.sami.crw.cli.analysis;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.SecondsConverter;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.net.PetriNet;
import org.sami.petri.pnml.PnmlReading;
import org.sami.petri.symmetry.NetSymmetry;
import org.sami.picture.states.StateGraphPicture;
import org.sami.spn.drawing.states.StateGraph;
import org.sami.spn.drawing.states.StateGraphDot;
import org.sami.spn.drawing.states.StateGraphLayout;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw graph}: the picture of a reachability graph. */
@Command(
        name = "graph",
        mixinStandardHelpOptions = true,
        description = "Draws the reachability graph of a Petri net in layers: a box for each state with its marked"
                + " places, an arrow for each firing.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the whole graph was drawn",
            "1:the file has errors",
            "2:wrong usage, or there is no such file",
            "5:a part was drawn: the budget was used up, as the picture says"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw graph line.pnml --svg line.svg",
            "  crw graph shared-memory-5 --symmetry --svg shared-memory.svg",
            "  crw graph philosophers-5 --states 1000 --dot philosophers.dot"
        })
public final class GraphCommand implements Callable<Integer> {
    private static final int MOST_DOT_STATES = 1_000_000;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(paramLabel = "FILE|NET", description = "A PNML file, or an example net by its name, such as kanban-1.")
    private String name = "";

    @Option(names = "--svg", paramLabel = "FILE", description = "Write the picture as SVG.")
    private @Nullable Path svg;

    @Option(names = "--dot", paramLabel = "FILE", description = "Write the graph in Graphviz's language DOT.")
    private @Nullable Path dot;

    @Option(
            names = "--states",
            paramLabel = "N",
            defaultValue = "200",
            description = "How many states are drawn, the nearest first; up to " + StateGraphLayout.MOST_STATES
                    + " as SVG. Default: ${DEFAULT-VALUE}.")
    private int states;

    @Option(
            names = "--time",
            paramLabel = "SECONDS",
            defaultValue = "60",
            converter = SecondsConverter.class,
            description = "How long the search may take. Default: ${DEFAULT-VALUE}.")
    private long millis;

    @Option(
            names = "--symmetry",
            description = "Draw states as one that differ only by an exchange of equal components.")
    private boolean isSymmetric;

    @Override
    public Integer call() throws IOException {
        SearchBudget budget = budget();
        PnmlReading reading = NetArgument.read(name);
        NetArgument.print(spec.commandLine().getErr(), name, reading.findings());
        Optional<PetriNet> net = reading.net();
        if (net.isEmpty()) {
            return ExitCode.FINDINGS;
        }
        ReachabilityGraph graph = search(net.get(), budget);
        String remark = remark(graph);
        StateGraph drawn = NetStateGraph.of(
                graph, net.get().name().isEmpty() ? name : net.get().name(), remark);
        PrintWriter out = spec.commandLine().getOut();
        out.println(net.get());
        out.println(remark);
        if (svg != null) {
            write(svg, StateGraphPicture.svg(drawn));
        }
        if (dot != null) {
            write(dot, StateGraphDot.of(drawn));
        }
        out.flush();
        return graph.isComplete() ? ExitCode.OK : ExitCode.RUNNING;
    }

    private SearchBudget budget() {
        if (svg == null && dot == null) {
            throw new UsageFault("where to? --svg FILE, --dot FILE or both");
        }
        int most = svg == null ? MOST_DOT_STATES : StateGraphLayout.MOST_STATES;
        if (states < 1 || states > most) {
            throw new UsageFault("--states is 1 to " + most + (svg == null ? "" : " with --svg") + ", not " + states);
        }
        if (millis == 0) {
            throw new UsageFault("--time is more than 0");
        }
        return new SearchBudget(states, Runtime.getRuntime().maxMemory() / 2, Duration.ofMillis(millis));
    }

    private ReachabilityGraph search(PetriNet net, SearchBudget budget) {
        SearchSettings whole = SearchSettings.within(budget);
        SearchSettings settings = isSymmetric ? whole.withSymmetry(NetSymmetry.of(net)) : whole;
        ProgressDisplay progress =
                new ProgressDisplay(spec.commandLine().getErr(), Terminal.onStandardError(), System::nanoTime);
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            GraphWatch watch = SearchProgress.watch(progress, stop);
            ReachabilityGraph graph = ReachabilitySearch.explore(net, settings, watch, System::nanoTime);
            progress.end();
            return graph;
        }
    }

    private String remark(ReachabilityGraph graph) {
        String alike = isSymmetric ? " up to symmetry" : "";
        return graph.isComplete()
                ? "all " + graph.states() + " states" + alike
                : "the nearest " + graph.states() + " states" + alike + ", " + (graph.states() - graph.looked())
                        + " of them not followed (dashed): bounded search only, as "
                        + graph.end().words();
    }

    private void write(Path file, String text) throws IOException {
        boolean isThere = Files.exists(file);
        if (file.getParent() != null) {
            Files.createDirectories(file.getParent());
        }
        Files.writeString(file, text, StandardCharsets.UTF_8);
        spec.commandLine().getOut().println((isThere ? "replaced " : "written to ") + file);
    }
}
