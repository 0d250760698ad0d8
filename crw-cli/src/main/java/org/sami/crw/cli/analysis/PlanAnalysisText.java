package org.sami.crw.cli.analysis;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.spn.plannet.Abstraction;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.planspace.PlanFacts;
import org.sami.spn.planspace.PlanQueryAnswer;
import org.sami.spn.planspace.PlanStateWords;
import org.sami.spn.planspace.PlanWitness;

/** An analysis of a plan as lines for people, in the plan's words. */
final class PlanAnalysisText {
    /** So many lines of what the net leaves open are printed; JSON has all. */
    private static final int MOST_OPEN = 6;

    /** So many lines of a proof are printed; JSON has all. */
    private static final int MOST_PROOF = 8;

    private final PrintWriter out;
    private final PlanAnalysis analysis;
    private final PlanStateWords words;

    PlanAnalysisText(PrintWriter out, PlanAnalysis analysis) {
        this.out = out;
        this.analysis = analysis;
        words = new PlanStateWords(analysis.plan().net());
    }

    void print() {
        out.printf(
                "%s: a net of %d places and %d transitions%s%n",
                analysis.plan().title(),
                analysis.plan().net().net().placeCount(),
                analysis.plan().net().net().transitionCount(),
                of(analysis.plan().net()));
        List<Abstraction> open = analysis.plan().net().abstractions();
        list(open, Abstraction.Kind.WIDER, "it can do more than the plan, as it leaves open:");
        list(open, Abstraction.Kind.PARTIAL, "it follows only a part of the plan:");
        if (open.isEmpty()) {
            out.println("it does exactly what the plan does");
        }
        analysis.facts().ifPresent(this::printGraph);
        analysis.answers().forEach(this::print);
        if (!analysis.mayBe().isEmpty()) {
            out.println("not certain, as the net can do more than the plan: "
                    + analysis.mayBe().stream()
                            .map(answer -> answer.query().name())
                            .collect(Collectors.joining(", ")));
        }
    }

    private static String of(PlanNet net) {
        return net.isCounted()
                ? ", in which boats are counted"
                : net.isPresent() ? ", in which it is followed whether any boats are in a place" : "";
    }

    private void list(List<Abstraction> all, Abstraction.Kind kind, String heading) {
        List<Abstraction> some = all.stream().filter(a -> a.kind() == kind).toList();
        if (some.isEmpty()) {
            return;
        }
        out.println(heading);
        some.stream().limit(MOST_OPEN).forEach(a -> out.println("    " + a.words()));
        if (some.size() > MOST_OPEN) {
            out.println("    and " + (some.size() - MOST_OPEN) + " more, which --json lists");
        }
    }

    private void printGraph(PlanFacts facts) {
        ReachabilityGraph graph = facts.graph();
        String gathering = facts.gathering().stream().map(words::place).collect(Collectors.joining(", "));
        out.println(
                !graph.isComplete()
                        ? "bounded search only: " + graph.end().words()
                        : "every state was looked at"
                                + (gathering.isEmpty() ? "" : "; tokens gather, and are not counted, in " + gathering));
        SearchSpeed speed = SearchSpeed.of(graph);
        out.printf(
                Locale.ROOT,
                "%d states up to an exchange of boats, %d edges in %.2f s: %.0f states a second, %.1f bytes a state%n",
                graph.states(),
                graph.edges(),
                speed.seconds(),
                speed.statesPerSecond(),
                speed.bytesPerState());
        print(facts, graph.isComplete());
    }

    private void print(PlanFacts facts, boolean isWhole) {
        String among = isWhole ? "" : " among these states";
        out.println(
                facts.neverFired().isEmpty()
                        ? "each transition fires somewhere"
                        : "never fired" + among + ": " + String.join(", ", facts.neverFired()));
        List<String> most = facts.mostRobots().entrySet().stream()
                .filter(place -> place.getValue() > 0)
                .map(place -> words.place(place.getKey()) + " " + place.getValue())
                .toList();
        if (!most.isEmpty()) {
            out.println("most boats at once" + among + ": " + String.join(", ", most));
        }
    }

    private void print(PlanQueryAnswer answer) {
        String name = analysis.kind() == PlanAnalysis.Kind.SAVED
                ? "\"" + answer.query().name() + "\" (" + answer.query().text() + ", expected "
                        + answer.query().expected().name().toLowerCase(Locale.ROOT) + ")"
                : answer.query().text();
        out.println(
                name + ": " + (answer.result() == PlanQueryAnswer.Result.FAULT ? "a fault, " : "") + answer.words());
        answer.proof().stream().limit(MOST_PROOF).forEach(line -> out.println("    " + line));
        if (answer.proof().size() > MOST_PROOF) {
            out.println("    and " + (answer.proof().size() - MOST_PROOF) + " more lines, which --json lists");
        }
        answer.witness().ifPresent(this::print);
        if (answer.states() > 0) {
            out.printf(Locale.ROOT, "    %d states in %.2f s%n", answer.states(), answer.nanos() / 1e9);
        }
    }

    private void print(PlanWitness witness) {
        witness.words().forEach(firing -> out.println("    " + firing));
        List<String> marked = witness.endWords();
        out.println("    then " + (marked.isEmpty() ? "no token anywhere" : String.join("; ", marked)));
    }
}
