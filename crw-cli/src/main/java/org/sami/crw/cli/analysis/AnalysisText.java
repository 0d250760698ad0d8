package org.sami.crw.cli.analysis;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.sami.petri.graph.ReachabilityGraph;

/** An analysis as lines for people. */
final class AnalysisText {
    /** So many names of a list are printed; JSON has all. */
    private static final int MOST_NAMES = 10;

    /** So many places of a marking are shown, in JSON too: a net can have hundreds of thousands with tokens. */
    static final int MOST_MARKED = 20;

    private final PrintWriter out;
    private final NetAnalysis analysis;

    AnalysisText(PrintWriter out, NetAnalysis analysis) {
        this.out = out;
        this.analysis = analysis;
    }

    void print() {
        analysis.answer()
                .ifPresentOrElse(this::printAnswer, () -> analysis.graph().ifPresent(this::printFacts));
        printWitness();
        analysis.graph().ifPresent(graph -> {
            SearchSpeed speed = SearchSpeed.of(graph);
            out.printf(
                    Locale.ROOT,
                    "%d states, %d edges in %.2f s: %.0f states a second, %.1f bytes a state%n",
                    graph.states(),
                    graph.edges(),
                    speed.seconds(),
                    speed.statesPerSecond(),
                    speed.bytesPerState());
        });
    }

    private void printAnswer(NetAnalysis.Answered answer) {
        out.println(answer.text() + ": " + answer.verdict().name().toLowerCase(Locale.ROOT) + ", " + answer.words());
        answer.proof().ifPresent(proof -> proof.words().forEach(line -> out.println("    " + line)));
    }

    private void printFacts(ReachabilityGraph graph) {
        boolean isWhole = graph.isComplete();
        out.println(
                isWhole
                        ? "every reachable state was looked at"
                        : "bounded search only: " + graph.end().words());
        String among = isWhole ? "" : " among these states";
        out.println(
                graph.deadlocks().isEmpty()
                        ? "no deadlock" + among
                        : counted(graph.deadlocks().size(), "deadlock") + among + ", the nearest after "
                                + analysis.witness()
                                        .map(run -> run.transitions().size())
                                        .orElse(0) + " firings");
        List<String> dead =
                graph.deadTransitions().stream().map(graph.net()::transitionId).toList();
        out.println(dead.isEmpty() ? "each transition fires somewhere" : "never fired" + among + ": " + listed(dead));
        int most = IntStream.range(0, graph.net().placeCount())
                .map(graph::mostTokens)
                .max()
                .orElse(0);
        out.println("at most " + counted(most, "token") + " in a place" + among);
    }

    private void printWitness() {
        analysis.witness().ifPresent(run -> {
            out.println("run: "
                    + (run.transitions().isEmpty()
                            ? "none, it is the initial marking"
                            : String.join(" ", run.ids(analysis.net()))));
            List<String> marked = analysis.marked(run.replay(analysis.net()));
            int more = marked.size() - MOST_MARKED;
            out.println("marking: " + String.join(" ", more > 0 ? marked.subList(0, MOST_MARKED) : marked)
                    + (more > 0 ? " ... and " + more + " more" : ""));
        });
    }

    private static String counted(int count, String noun) {
        return count + " " + noun + (count == 1 ? "" : "s");
    }

    private static String listed(List<String> names) {
        return names.size() <= MOST_NAMES
                ? String.join(", ", names)
                : String.join(", ", names.subList(0, MOST_NAMES)) + " and " + (names.size() - MOST_NAMES) + " more";
    }
}
