package org.sami.crw.cli.analysis;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.sami.petri.coverability.CoverabilityAnswers;
import org.sami.petri.coverability.CoverabilitySet;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.net.PetriNet;
import org.sami.petri.structure.IntegerVector;
import org.sami.petri.structure.InvariantSet;
import org.sami.petri.structure.Invariants;
import org.sami.petri.structure.MarkingBound;
import org.sami.petri.structure.SiphonTrapCheck;
import org.sami.petri.structure.StructuralAnswers;
import org.sami.petri.structure.StructuralProof;
import org.sami.petri.structure.StructureLimits;

/**
 * What {@code crw analyse --structure} says of a net.
 *
 * @param bounds by place; empty where structure gives none
 * @param basis of all P-invariants, those with negative weights too; empty where it was not computed
 * @param siphons whether each siphon contains a marked trap
 * @param neverStops why some transition is always enabled; empty where that is not proved
 * @param isLive why each transition can always fire again; empty where that is not proved
 * @param coverability only where structure does not bound all places
 * @param cutAfter how long structure was searched, where that was not enough; empty where all was tried
 */
record StructureFacts(
        PetriNet net,
        InvariantSet placeInvariants,
        Optional<List<IntegerVector>> basis,
        InvariantSet transitionInvariants,
        List<Optional<MarkingBound>> bounds,
        SiphonTrapCheck.Result siphons,
        Optional<StructuralProof> neverStops,
        Optional<StructuralProof> isLive,
        Optional<CoverabilityAnswers> coverability,
        Optional<Duration> cutAfter) {

    static StructureFacts of(PetriNet net, SearchBudget budget, GraphWatch watch, BooleanSupplier stop) {
        long deadline = System.nanoTime() + budget.time().toNanos();
        StructureLimits limits = StructureLimits.USUAL.withCancel(stop).until(deadline, System::nanoTime);
        StructuralAnswers answers = new StructuralAnswers(net, limits);
        List<Optional<MarkingBound>> bounds = new ArrayList<>();
        for (int place = 0; place < net.placeCount(); place++) {
            bounds.add(answers.bound(place));
        }
        StructureFacts facts = new StructureFacts(
                net,
                answers.invariants(),
                Invariants.basisOfPlaces(net, limits),
                Invariants.ofTransitions(net, limits),
                bounds,
                answers.siphons(),
                answers.neverStops(),
                answers.isLive(),
                Optional.empty(),
                Optional.empty());
        return limits.cancelled().getAsBoolean()
                ? facts.cut(budget.time())
                : bounds.stream().allMatch(Optional::isPresent)
                        ? facts
                        : facts.with(CoverabilityAnswers.of(net, answers, budget, watch, System::nanoTime));
    }

    private StructureFacts cut(Duration after) {
        return with(coverability, Optional.of(after));
    }

    private StructureFacts with(CoverabilityAnswers answers) {
        return with(Optional.of(answers), cutAfter);
    }

    private StructureFacts with(Optional<CoverabilityAnswers> answers, Optional<Duration> cut) {
        return new StructureFacts(
                net, placeInvariants, basis, transitionInvariants, bounds, siphons, neverStops, isLive, answers, cut);
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

    /** Transitions that never fire, as a complete coverability set shows; none where there is no such set. */
    List<Integer> neverFiring() {
        return coverability.map(CoverabilityAnswers::set).filter(CoverabilitySet::isComplete).stream()
                .flatMap(set -> IntStream.range(0, net.transitionCount())
                        .filter(transition -> !set.canFire(transition))
                        .boxed())
                .toList();
    }

    /** Whether it is open which places are unbounded, or time did not do for all that structure may prove. */
    boolean isOpen() {
        return cutAfter.isPresent()
                || coverability.filter(answers -> !answers.set().isComplete()).isPresent();
    }
}
