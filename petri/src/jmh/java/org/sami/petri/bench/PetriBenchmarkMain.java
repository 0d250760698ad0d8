package org.sami.petri.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import org.sami.figures.Figure;
import org.sami.figures.FigureFile;
import org.sami.petri.coverability.CoverabilitySearch;
import org.sami.petri.coverability.CoverabilitySet;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.model.ExampleNets;
import org.sami.petri.net.PetriNet;
import org.sami.petri.structure.LinearCondition;
import org.sami.petri.structure.StructuralAnswers;
import org.sami.petri.structure.StructuralProof;
import org.sami.petri.structure.StructureLimits;
import org.sami.petri.symmetry.NetSymmetry;

/**
 * Measures the search in turn with an explorer that keeps markings in a hash set, by the processor time of the thread, prints a table and puts it into the file of
 * all benchmarks. System properties: {@code benchmarks.file}; {@code quick} = true for smaller nets and fewer rounds.
 */
public final class PetriBenchmarkMain {
    private static final String PREFIX = "petri.";

    private final boolean quick = Boolean.getBoolean("quick");
    private final List<Figure> figures = new ArrayList<>();

    private PetriBenchmarkMain() {}

    /** No arguments. */
    public static void main(String[] args) throws IOException {
        new PetriBenchmarkMain().run();
    }

    private void run() throws IOException {
        measure("kanban", ExampleNets::kanban, quick ? 4 : 5);
        measure("philosophers", ExampleNets::philosophers, quick ? 11 : 13);
        bySymmetry(12);
        bySymmetry(20);
        coverability(2);
        exclusion(20);
        FigureFile.print(figures);
        FigureFile.replace(FigureFile.ofThisBuild(), PREFIX, figures);
        System.out.println("Written to " + FigureFile.ofThisBuild());
    }

    private void measure(String name, IntFunction<PetriNet> family, int size) {
        PetriNet net = family.apply(size);
        SearchSettings settings = SearchSettings.within(SearchBudget.ofStates(SearchBudget.MOST_STATES));
        List<Double> speeds = new ArrayList<>();
        List<Double> ratios = new ArrayList<>();
        double bytes = 0;
        for (int round = 0; round <= (quick ? 2 : 5); round++) {
            Timed<ReachabilityGraph> ours = timed(() -> ReachabilitySearch.explore(net, settings));
            Timed<HashSetExplorer> plain = timed(() -> explored(net));
            ReachabilityGraph graph = ours.result();
            if (!graph.isComplete() || graph.edges() != plain.result().edges()) {
                throw new IllegalStateException("the explorers of " + net + " do not agree");
            }
            if (round > 0) { // the first one warms the machine code up
                speeds.add(graph.states() / ours.seconds());
                ratios.add(plain.seconds() / ours.seconds());
                bytes = (double) graph.bytes() / graph.states();
            }
        }
        Map<String, Integer> parameters = Map.of(name, size);
        figures.add(new Figure(PREFIX + name, parameters, median(speeds), "states/s", 0));
        figures.add(new Figure(PREFIX + "ratio", parameters, median(ratios), "", 0));
        figures.add(new Figure(PREFIX + "bytes", parameters, bytes, "bytes/state", 0));
    }

    /** The symmetry of a net is found, and its graph searched by it. */
    private void bySymmetry(int agents) {
        PetriNet net = ExampleNets.agents(agents);
        List<Double> seconds = new ArrayList<>();
        for (int round = 0; round <= (quick ? 2 : 5); round++) {
            Timed<ReachabilityGraph> ours = timed(() -> ReachabilitySearch.explore(
                    net,
                    SearchSettings.within(SearchBudget.ofStates(SearchBudget.MOST_STATES))
                            .withSymmetry(NetSymmetry.of(net))));
            if (!ours.result().isComplete()) {
                throw new IllegalStateException("the graph of " + net + " is not complete");
            }
            if (round > 0) {
                seconds.add(ours.seconds());
            }
        }
        figures.add(new Figure(PREFIX + "symmetry", Map.of("agents", agents), median(seconds), "s", 0));
    }

    private void coverability(int cards) {
        PetriNet net = ExampleNets.openKanban(cards);
        SearchBudget budget = SearchBudget.ofStates(SearchBudget.MOST_STATES);
        List<Double> seconds = new ArrayList<>();
        for (int round = 0; round <= (quick ? 2 : 5); round++) {
            Timed<CoverabilitySet> ours =
                    timed(() -> CoverabilitySearch.search(net, budget, GraphWatch.NONE, System::nanoTime));
            if (!ours.result().isComplete()) {
                throw new IllegalStateException("the coverability set of " + net + " is not complete");
            }
            if (round > 0) {
                seconds.add(ours.seconds());
            }
        }
        figures.add(new Figure(PREFIX + "coverability", Map.of("kanban", cards), median(seconds), "s", 0));
    }

    /** Two agents are never in the gate together, proved by an invariant; the invariants are computed each time. */
    private void exclusion(int agents) {
        PetriNet net = ExampleNets.agents(agents);
        LinearCondition both = new LinearCondition.AllOf(List.of(
                LinearCondition.atLeast(net.place("step0.4").orElseThrow(), 1),
                LinearCondition.atLeast(net.place("step1.5").orElseThrow(), 1)));
        List<Double> millis = new ArrayList<>();
        for (int round = 0; round <= (quick ? 2 : 5); round++) {
            Timed<Optional<StructuralProof>> ours =
                    timed(() -> new StructuralAnswers(net, StructureLimits.USUAL).never(both));
            if (ours.result().isEmpty()) {
                throw new IllegalStateException("two agents of " + net + " in the gate are not excluded");
            }
            if (round > 0) {
                millis.add(ours.seconds() * 1e3);
            }
        }
        figures.add(new Figure(PREFIX + "exclusion", Map.of("agents", agents), median(millis), "ms", 0));
    }

    private static HashSetExplorer explored(PetriNet net) {
        HashSetExplorer explorer = new HashSetExplorer(net);
        explorer.explore();
        return explorer;
    }

    private record Timed<T>(T result, double seconds) {}

    private static <T> Timed<T> timed(Supplier<T> work) {
        long before = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        T result = work.get();
        return new Timed<>(result, (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - before) / 1e9);
    }

    private static double median(List<Double> values) {
        return values.stream().sorted().skip(values.size() / 2).findFirst().orElseThrow();
    }
}
