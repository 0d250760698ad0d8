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
import org.sami.crw.cli.option.DepthOption;
import org.sami.crw.cli.option.DomainOption;
import org.sami.crw.cli.option.PlanOption;
import org.sami.crw.cli.option.PlanSource;
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
import org.sami.spn.planspace.StateGraphs;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw graph}: the picture of a reachability graph. */
@Command(
        name = "graph",
        mixinStandardHelpOptions = true,
        description =
                "Draws what a plan with its boats, or a Petri net, can reach, in layers: a box for each state with"
                        + " its marked places, an arrow for each firing.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the whole graph was drawn",
            "1:the file has errors",
            "2:wrong usage, or there is no such file",
            "5:a part was drawn: the budget was used up, as the picture says"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw graph clv --boats 2 --symmetry --svg clv-states.svg",
            "  crw graph my-plan.json --plan search --dot search.dot",
            "  crw graph line.pnml --svg line.svg",
            "  crw graph shared-memory-5 --symmetry --svg shared-memory.svg",
            "  crw graph philosophers-5 --states 1000 --dot philosophers.dot"
        })
public final class GraphCommand implements Callable<Integer> {
    private static final int MOST_DOT_STATES = 1_000_000;
    private static final int MOST_DRAWN_TRANSITIONS = 200;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(
            paramLabel = "FILE|PLAN|NET",
            description = "A project's file or folder, a plan of the library by its id, a PNML file, or an example net"
                    + " by its name, such as kanban-1.")
    private String name = "";

    @Mixin
    private DomainOption domain = new DomainOption();

    @Mixin
    private PlanOption planOption = new PlanOption();

    @Option(
            names = "--boats",
            paramLabel = "N",
            defaultValue = "2",
            description = "With a plan: how many boats there are at the start. Default: ${DEFAULT-VALUE}.")
    private int boats;

    @Mixin
    private DepthOption depth = new DepthOption();

    @Option(names = "--svg", paramLabel = "FILE", description = "Write the picture as SVG.")
    private @Nullable Path svg;

    @Option(names = "--dot", paramLabel = "FILE", description = "Write the graph in Graphviz's language DOT.")
    private @Nullable Path dot;

    @Option(
            names = "--net",
            paramLabel = "FILE",
            description = "Write the picture of the net itself as SVG; of a plan's net without the places by which it"
                    + " only follows the rules of the engine.")
    private @Nullable Path netFile;

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
        Optional<DrawnNet> drawnNet = PlanArgument.isNet(name) ? net() : plan();
        if (drawnNet.isEmpty()) {
            return ExitCode.FINDINGS;
        }
        DrawnNet net = drawnNet.get();
        if (netFile != null) {
            write(netFile, picture(net));
            if (svg == null && dot == null) {
                return ExitCode.OK;
            }
        }
        ReachabilityGraph graph = search(net.net(), budget);
        StateGraph drawn = StateGraphs.of(graph, net.title(), isSymmetric, net.words());
        PrintWriter out = spec.commandLine().getOut();
        out.println(net.net());
        net.remarks().forEach(remark -> out.println("  " + remark));
        out.println(drawn.remark());
        if (svg != null) {
            write(svg, StateGraphPicture.svg(drawn));
        }
        if (dot != null) {
            write(dot, StateGraphDot.of(drawn));
        }
        out.flush();
        return graph.isComplete() ? ExitCode.OK : ExitCode.RUNNING;
    }

    private static String picture(DrawnNet net) {
        if (net.net().transitionCount() > MOST_DRAWN_TRANSITIONS) {
            throw new UsageFault("--net: a picture has up to " + MOST_DRAWN_TRANSITIONS + " transitions, the net has "
                    + net.net().transitionCount());
        }
        return PetriNetPicture.svg(
                net.net(), net.title(), net.isDrawn(), PlanSource.library().vocabulary());
    }

    private Optional<DrawnNet> net() throws IOException {
        PnmlReading reading = NetArgument.read(name);
        NetArgument.print(spec.commandLine().getErr(), name, reading.findings());
        return reading.net().map(net -> DrawnNet.of(net, name));
    }

    private Optional<DrawnNet> plan() {
        return PlanArgument.read(
                        name,
                        domain,
                        planOption.name(),
                        boats,
                        depth.levels(),
                        true,
                        spec.commandLine().getErr())
                .map(DrawnNet::of);
    }

    private SearchBudget budget() {
        if (svg == null && dot == null && netFile == null) {
            throw new UsageFault("where to? --svg FILE, --dot FILE or both; --net FILE for the net itself");
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

    private void write(Path file, String text) throws IOException {
        boolean isThere = Files.exists(file);
        if (file.getParent() != null) {
            Files.createDirectories(file.getParent());
        }
        Files.writeString(file, text, StandardCharsets.UTF_8);
        spec.commandLine().getOut().println((isThere ? "replaced " : "written to ") + file);
    }
}
