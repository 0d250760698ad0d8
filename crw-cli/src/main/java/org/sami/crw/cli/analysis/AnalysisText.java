package org.sami.crw.cli.analysis;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import org.sami.petri.graph.ReachabilityGraph;

/** An analysis as lines for people. */
final class AnalysisText {
    /** So many names of a list are printed; JSON has all. */
    private static final int MOST_NAMES = 10;

    private final PrintWriter out;
    private final NetAnalysis analysis;

    AnalysisText(PrintWriter out, NetAnalysis analysis) {
        this.out = out;
        this.analysis = analysis;
    }

    void print() {
        ReachabilityGraph graph = analysis.graph();
        analysis.answer()
                .ifPresentOrElse(
                        answer -> out.println(analysis.query() + ": "
                                + answer.verdict().name().toLowerCase(Locale.ROOT) + ", " + answer.words()),
                        this::printFacts);
        printWitness();
        out.printf(
                Locale.ROOT,
                "%d states, %d edges in %.2f s: %.0f states a second, %.1f bytes a state%n",
                graph.states(),
                graph.edges(),
                analysis.seconds(),
                analysis.statesPerSecond(),
                analysis.bytesPerState());
    }

    private void printFacts() {
        ReachabilityGraph graph = analysis.graph();
        boolean isWhole = graph.isComplete();
        out.println(
                isWhole
                        ? "every reachable state was looked at"
                        : "bounded search only: " + graph.end().words());
        String among = isWhole ? "" : " among these states";
        out.println(
                graph.deadlocks().isEmpty()
                        ? "no deadlock" + among
                        : graph.deadlocks().size() + " deadlocks" + among + ", the nearest after "
                                + analysis.witness()
                                        .map(run -> run.transitions().size())
                                        .orElse(0) + " firings");
        List<String> dead = graph.deadTransitions().stream()
                .map(analysis.net()::transitionId)
                .toList();
        out.println(dead.isEmpty() ? "each transition fires somewhere" : "never fired" + among + ": " + listed(dead));
        out.println("at most " + analysis.mostTokens() + " tokens in a place" + among);
    }

    private void printWitness() {
        analysis.witness().ifPresent(run -> {
            out.println("run: "
                    + (run.transitions().isEmpty()
                            ? "none, it is the initial marking"
                            : String.join(" ", run.ids(analysis.net()))));
            out.println("marking: " + String.join(" ", analysis.marked(run.replay(analysis.net()))));
        });
    }

    private static String listed(List<String> names) {
        return names.size() <= MOST_NAMES
                ? String.join(", ", names)
                : String.join(", ", names.subList(0, MOST_NAMES)) + " and " + (names.size() - MOST_NAMES) + " more";
    }
}
