package org.sami.petri.coverability;

import java.util.BitSet;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.LongSupplier;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.net.PetriNet;
import org.sami.petri.symmetry.NetSymmetry;

/**
 * Searches a net until tokens gather in places that can be saturated, then saturates these and searches again: first exactly, then up to how many tokens are there. For
 * one thread.
 */
public final class SaturatedSearch {
    /** A place gathers tokens where it has so many: no arc tells that from one. */
    private static final int GATHERED = 2;

    private final WiderNet wider;
    private final PetriNet net;
    private final BitSet candidates;
    private final SearchBudget budget;
    private final Function<PetriNet, NetSymmetry> symmetries;
    private final GraphWatch watch;
    private final LongSupplier nanos;

    /**
     * A search of a net.
     *
     * @param wider the net
     * @param candidates places that may be saturated where they can be; others are always counted
     * @param symmetries what can be exchanged in the net, and in others with the same places
     * @param budget of each of its searches
     */
    public SaturatedSearch(
            WiderNet wider,
            BitSet candidates,
            SearchBudget budget,
            Function<PetriNet, NetSymmetry> symmetries,
            GraphWatch watch,
            LongSupplier nanos) {
        this.wider = wider;
        net = wider.net();
        this.candidates = (BitSet) candidates.clone();
        this.candidates.and(new SaturablePlaces(net).all());
        this.budget = budget;
        this.symmetries = symmetries;
        this.watch = watch;
        this.nanos = nanos;
    }

    /**
     * The graph of the net with its edges, as far as no place gathers tokens: complete where none does.
     */
    public ReachabilityGraph exact() {
        SearchSettings settings = SearchSettings.within(budget).withEdges().withGoal(this::gathers);
        NetSymmetry symmetry = symmetries.apply(net);
        return ReachabilitySearch.explore(
                net, symmetry.isEmpty() ? settings : settings.withSymmetry(symmetry), watch, nanos);
    }

    /**
     * The graph with places saturated; empty where the budget did not do, or nothing gathers and the net stands for itself.
     *
     * @param found the graph that ended where a place had gathered tokens
     */
    public Optional<SaturatedQueries> saturated(ReachabilityGraph found) {
        BitSet gathering = new BitSet();
        ReachabilityGraph graph = found;
        while (graph.found().isPresent() || (graph == found && !wider.isExact())) {
            if (graph.found().isPresent()) {
                int[] marking = graph.marking(graph.found().getAsInt());
                candidates.stream().filter(place -> marking[place] >= GATHERED).forEach(gathering::set);
            }
            SaturatedNet saturated = SaturatedNet.of(net, gathering);
            SearchSettings settings = SearchSettings.within(budget)
                    .withEdgesOf(t -> saturated.isSure(t) && wider.isSure(saturated.original(t)))
                    .withGoal(this::gathers);
            NetSymmetry like = symmetries.apply(saturated.net());
            graph = ReachabilitySearch.explore(
                    saturated.net(), like.isEmpty() ? settings : settings.withSymmetry(like), watch, nanos);
            if (graph.isComplete()) {
                return Optional.of(new SaturatedQueries(wider, saturated, graph, budget.bytes()));
            }
        }
        return Optional.empty();
    }

    private boolean gathers(int[] marking) {
        for (int place = candidates.nextSetBit(0); place >= 0; place = candidates.nextSetBit(place + 1)) {
            if (marking[place] >= GATHERED) {
                return true;
            }
        }
        return false;
    }
}
