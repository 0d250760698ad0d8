package org.sami.petri.coverability;

import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import java.util.stream.Collectors;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.net.PetriNet;
import org.sami.petri.structure.StructuralAnswers;

/**
 * The coverability set of a net, and what it proves. Boundedness and coverability are decidable without inhibitor and reset arcs. With them they are decided where the
 * places of those arcs are bounded: because structure proves a bound, or because the search ended. Otherwise the answer says that it is undecided, and how far was
 * searched.
 *
 * @param set what was found
 * @param unproved places with inhibitor or reset arcs of which structure proves no bound: with any, the search need not end
 */
public record CoverabilityAnswers(CoverabilitySet set, List<Integer> unproved) {
    public CoverabilityAnswers {
        unproved = List.copyOf(unproved);
    }

    /**
     * Searches within a budget.
     *
     * @param structure of the same net
     * @param nanos the clock, in ns
     */
    public static CoverabilityAnswers of(
            PetriNet net, StructuralAnswers structure, SearchBudget budget, GraphWatch watch, LongSupplier nanos) {
        List<Integer> unproved = new ArrayList<>();
        for (int place : new MarkingOrder(net).exactPlaces()) {
            if (structure.mostTokens(place).isEmpty()) {
                unproved.add(place);
            }
        }
        return new CoverabilityAnswers(CoverabilitySearch.search(net, budget, watch, nanos), unproved);
    }

    /** What the result is worth, in a sentence. */
    public String words(PetriNet net) {
        if (set.isComplete()) {
            return "minimal coverability set of " + set.size() + " markings";
        }
        String searched =
                "searched to " + set.searched() + " markings (" + set.end().words() + ")";
        return unproved.isEmpty()
                ? "bounded search only: " + searched
                : "undecidable here, as inhibitor or reset arcs go to places without a proved bound ("
                        + unproved.stream().map(net::placeName).collect(Collectors.joining(", ")) + "): " + searched;
    }

    /** The unbounded places, by number. They are all where the set is complete. */
    public List<Integer> unbounded(PetriNet net) {
        List<Integer> places = new ArrayList<>();
        for (int place = 0; place < net.placeCount(); place++) {
            if (set.isUnbounded(place)) {
                places.add(place);
            }
        }
        return places;
    }
}
