package org.sami.crw.cli.analysis;

import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.sami.petri.coverability.CoverabilityQueries;
import org.sami.petri.coverability.CoverabilitySearch;
import org.sami.petri.coverability.CoverabilitySet;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.NetQuery;
import org.sami.petri.structure.StructuralAnswers;
import org.sami.petri.structure.StructuralQueries;
import org.sami.petri.structure.StructureLimits;

/**
 * Answers queries before states are searched: by the structure of the net, and, where that does not bound all places, by its coverability set, as a search through states
 * might never end. The set is computed once, for the first query that it can answer, in a quarter of the memory; where that is not enough nothing of it is kept.
 */
final class ProofsBeforeSearch {
    /** More markings than that take longer than they are worth here. */
    private static final int MOST_MARKINGS = 200_000;

    private static final int PART_OF_MEMORY = 4;

    /** So long structure is tried, for all queries together, before states are searched. */
    private static final Duration MOST_TIME = Duration.ofSeconds(10);

    private final PetriNet net;
    private final SearchBudget budget;
    private final GraphWatch watch;
    private final BooleanSupplier cut;
    private final StructuralAnswers structure;
    private boolean asked;
    private @Nullable CoverabilityQueries coverability;

    ProofsBeforeSearch(PetriNet net, SearchBudget budget, GraphWatch watch, BooleanSupplier stop) {
        this.net = net;
        this.budget = budget;
        this.watch = watch;
        long deadline = System.nanoTime() + Math.min(budget.time().toNanos(), MOST_TIME.toNanos());
        this.cut = () -> stop.getAsBoolean() || System.nanoTime() - deadline >= 0;
        this.structure = new StructuralAnswers(
                net, StructureLimits.USUAL.withCancel(stop).until(deadline, System::nanoTime));
    }

    /** The answer; empty where states have to be searched. */
    Optional<NetAnalysis> answer(String text, NetQuery query) {
        Optional<NetAnalysis> byStructure = new StructuralQueries(net, structure)
                .answer(query)
                .map(answer -> NetAnalysis.of(net, text, query, answer));
        if (byStructure.isPresent() || !CoverabilityQueries.mayAnswer(query)) {
            return byStructure;
        }
        return coverability()
                .flatMap(queries -> queries.answer(query))
                .map(answer -> NetAnalysis.of(net, text, query, answer));
    }

    private Optional<CoverabilityQueries> coverability() {
        if (!asked) {
            asked = true;
            coverability = mayBeUnbounded() ? searched().orElse(null) : null;
        }
        return Optional.ofNullable(coverability);
    }

    /** Whether structure was tried to the end, and does not bound all places. */
    private boolean mayBeUnbounded() {
        for (int place = 0; place < net.placeCount() && !cut.getAsBoolean(); place++) {
            if (structure.mostTokens(place).isEmpty()) {
                return !cut.getAsBoolean();
            }
        }
        return false;
    }

    private Optional<CoverabilityQueries> searched() {
        SearchBudget some = new SearchBudget(
                Math.min(MOST_MARKINGS, budget.states()), budget.bytes() / PART_OF_MEMORY, budget.time());
        return Optional.of(CoverabilitySearch.search(net, some, watch, System::nanoTime))
                .filter(CoverabilitySet::isComplete)
                .map(set -> new CoverabilityQueries(net, set));
    }
}
