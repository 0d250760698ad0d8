package org.sami.crw.cli.analysis;

import java.io.PrintWriter;
import java.math.BigDecimal;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.sami.petri.coverability.CoverabilityAnswers;
import org.sami.petri.coverability.CoverabilitySet;
import org.sami.petri.net.PetriNet;
import org.sami.petri.structure.IntegerVector;
import org.sami.petri.structure.InvariantSet;
import org.sami.petri.structure.StructuralProof;

/** Facts from structure as lines for people. */
final class StructureText {
    /** So many lines of a list are printed; JSON has all. */
    private static final int MOST_LINES = 20;

    private final PrintWriter out;
    private final StructureFacts facts;
    private final PetriNet net;

    StructureText(PrintWriter out, StructureFacts facts) {
        this.out = out;
        this.facts = facts;
        this.net = facts.net();
    }

    void print() {
        List<String> sums = new ArrayList<>();
        for (IntegerVector invariant : facts.placeInvariants().invariants()) {
            sums.add(invariant.words(net::placeName) + " is always " + invariant.times(net.initialMarking()));
        }
        printList("P-invariants", facts.placeInvariants(), sums);
        facts.basis()
                .filter(basis ->
                        basis.size() != facts.placeInvariants().invariants().size())
                .ifPresent(basis -> out.println("    with negative weights too, all are sums of " + basis.size()));
        List<String> rounds = new ArrayList<>();
        for (IntegerVector invariant : facts.transitionInvariants().invariants()) {
            rounds.add(invariant.words(net::transitionName));
        }
        printList("T-invariants, firings that together change nothing", facts.transitionInvariants(), rounds);
        printProof(facts.neverStops());
        if (facts.isLive().isPresent()) {
            out.println("each transition can always fire again, as the net is free-choice");
        }
        facts.coverability().ifPresent(this::printCoverability);
        if (!facts.neverFiring().isEmpty()) {
            out.println("never fires: "
                    + listed(facts.neverFiring().stream().map(net::transitionId).toList(), ", "));
        }
        printBounds();
    }

    private void printList(String what, InvariantSet found, List<String> lines) {
        out.println(what + ": " + lines.size() + (found.complete() ? "" : "; not all were computed"));
        printLines(lines);
    }

    private void printLines(List<String> lines) {
        lines.stream().limit(MOST_LINES).forEach(line -> out.println("    " + line));
        if (lines.size() > MOST_LINES) {
            out.println("    and " + (lines.size() - MOST_LINES) + " more");
        }
    }

    private void printProof(Optional<StructuralProof> neverStops) {
        if (neverStops.isPresent()) {
            out.println("no deadlock, proved by " + neverStops.get().method().words());
            printLines(neverStops.get().words());
        } else {
            out.println(facts.cutAfter()
                    .map(time -> "whether there is no deadlock was " + notDecided(time))
                    .orElse("structure does not prove that there is no deadlock"));
            facts.siphons()
                    .unmarked()
                    .ifPresent(siphon -> out.println("    siphon "
                            + siphon.stream().mapToObj(net::placeName).collect(Collectors.joining(", ", "{", "}"))
                            + " contains no marked trap: it may become empty, and stays so"));
        }
    }

    private void printCoverability(CoverabilityAnswers answers) {
        out.println(answers.words(net)
                + (facts.isOpen()
                        ? ""
                        : ", its graph has " + answers.set().graph().edges().size() + " edges"));
        for (int place : answers.unbounded(net)) {
            out.println("    " + net.placeName(place) + " is unbounded (ω)"
                    + answers.set().pump(place).map(this::words).orElse(""));
        }
    }

    private String words(CoverabilitySet.Pump pump) {
        String lead = pump.lead().isEmpty() ? "" : ", after " + names(pump.lead());
        return ": it grows with each round of " + names(pump.repeated()) + lead;
    }

    /** Places of the same bound stand in one line. */
    private void printBounds() {
        Map<Long, List<String>> names = new TreeMap<>();
        List<String> open = new ArrayList<>();
        for (int place = 0; place < net.placeCount(); place++) {
            OptionalLong most = facts.mostTokens(place);
            if (most.isPresent()) {
                names.computeIfAbsent(most.getAsLong(), bound -> new ArrayList<>())
                        .add(net.placeName(place));
            } else if (facts.isOpen()) {
                open.add(net.placeName(place));
            }
        }
        names.forEach((most, places) -> out.println("at most " + most + " tokens: " + listed(places, ", ")));
        if (!open.isEmpty()) {
            out.println(
                    facts.cutAfter().map(time -> "bounds " + notDecided(time)).orElse("no bound is known") + ": "
                            + listed(open, ", "));
        }
    }

    private static String notDecided(Duration time) {
        return String.format(
                Locale.ROOT,
                "not decided within %s s",
                BigDecimal.valueOf(time.toMillis(), 3).stripTrailingZeros().toPlainString());
    }

    private String names(List<Integer> transitions) {
        return listed(transitions.stream().map(net::transitionId).toList(), " ");
    }

    private static String listed(List<String> names, String between) {
        return names.size() <= MOST_LINES
                ? String.join(between, names)
                : String.join(between, names.subList(0, MOST_LINES)) + " and " + (names.size() - MOST_LINES) + " more";
    }
}
