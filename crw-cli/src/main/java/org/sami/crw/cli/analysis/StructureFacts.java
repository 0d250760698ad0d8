package org.sami.crw.cli.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.function.BooleanSupplier;
import org.sami.petri.coverability.CoverabilityAnswers;
import org.sami.petri.coverability.CoverabilitySet;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.net.PetriNet;
import org.sami.petri.structure.InvariantSet;
import org.sami.petri.structure.Invariants;
import org.sami.petri.structure.MarkingBound;
import org.sami.petri.structure.StructuralAnswers;
import org.sami.petri.structure.StructuralProof;
import org.sami.petri.structure.StructureLimits;

/**
 * What {@code crw analyse --structure} says of a net.
 *
 * @param bounds by place; empty where structure gives none
 * @param neverStops why some transition is always enabled; empty where that is not proved
 * @param isLive why each transition can always fire again; empty where that is not proved
 * @param coverability only where structure does not bound all places
 */
record StructureFacts(
        PetriNet net,
        InvariantSet placeInvariants,
        InvariantSet transitionInvariants,
        List<Optional<MarkingBound>> bounds,
        Optional<StructuralProof> neverStops,
        Optional<StructuralProof> isLive,
        Optional<CoverabilityAnswers> coverability) {

    static StructureFacts of(PetriNet net, SearchBudget budget, GraphWatch watch, BooleanSupplier stop) {
        long deadline = System.nanoTime() + budget.time().toNanos();
        StructureLimits limits =
                StructureLimits.USUAL.withCancel(() -> stop.getAsBoolean() || System.nanoTime() - deadline >= 0);
        StructuralAnswers answers = new StructuralAnswers(net, limits);
        List<Optional<MarkingBound>> bounds = new ArrayList<>();
        for (int place = 0; place < net.placeCount(); place++) {
            bounds.add(answers.bound(place));
        }
        return new StructureFacts(
                net,
                answers.invariants(),
                Invariants.ofTransitions(net, limits),
                bounds,
                answers.neverStops(),
                answers.isLive(),
                bounds.stream().allMatch(Optional::isPresent)
                        ? Optional.empty()
                        : Optional.of(CoverabilityAnswers.of(net, answers, budget, watch, System::nanoTime)));
    }

    /** The most tokens that a place can have: exact where the coverability set is complete, else what structure says; empty where no bound is known. */
    OptionalLong mostTokens(int place) {
        Optional<CoverabilitySet> set =
                coverability.map(CoverabilityAnswers::set).filter(CoverabilitySet::isComplete);
        if (set.isPresent()) {
            OptionalInt most = set.get().mostTokens(place);
            return most.isPresent() ? OptionalLong.of(most.getAsInt()) : OptionalLong.empty();
        }
        Optional<MarkingBound> bound = bounds.get(place);
        return bound.isPresent() ? OptionalLong.of(bound.get().mostTokens(place)) : OptionalLong.empty();
    }

    /** Whether it is open which places are unbounded. */
    boolean isOpen() {
        return coverability.filter(answers -> !answers.set().isComplete()).isPresent();
    }
}
