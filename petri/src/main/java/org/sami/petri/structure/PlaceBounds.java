package org.sami.petri.structure;

import java.util.IdentityHashMap;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.sami.petri.net.PetriNet;
import org.sami.petri.structure.LinearProgram.Outcome;

/**
 * Bounds of places that hold in every reachable marking: by the P-invariant that bounds a place lowest, and, where that is not asked for or there is none, by the weights
 * of places that never grow in sum and bound it lowest. Such weights exist exactly where no choice of firings can add to the place without end, whatever the initial
 * marking; a place without them may still be bounded from its initial marking, which structure does not see. Sound with inhibitor arcs, and with reset arcs, which only
 * make such sums smaller.
 *
 * <p>Source: Silva, Teruel and Colom, "Linear algebraic and linear programming techniques for the analysis of place/transition net systems", Lectures on Petri Nets I,
 * LNCS 1491, 1998, section 4.
 */
public final class PlaceBounds {
    private final PetriNet net;
    private final Incidence incidence;
    private final LongSupplier millisLeft;

    /** What weights bound, by the weights, as most of them bound many places. */
    private final IdentityHashMap<IntegerVector, Optional<MarkingBound>> known = new IdentityHashMap<>();

    /** Bounds of the places of a net. */
    public PlaceBounds(PetriNet net) {
        this(net, () -> Long.MAX_VALUE);
    }

    /** @param millisLeft how long a linear program may take from now on, in ms */
    PlaceBounds(PetriNet net, LongSupplier millisLeft) {
        this.net = net;
        this.millisLeft = millisLeft;
        this.incidence = Incidence.of(net);
    }

    /** The lowest bound by one of some P-invariants. */
    public Optional<MarkingBound> byInvariants(InvariantSet invariants, int place) {
        MarkingBound best = null;
        for (IntegerVector weights : invariants.invariants()) {
            if (weights.get(place) > 0) {
                Optional<MarkingBound> bound = known.computeIfAbsent(weights, this::bound);
                if (bound.isPresent() && (best == null || bound.get().mostTokens(place) < best.mostTokens(place))) {
                    best = bound.get();
                }
            }
        }
        return Optional.ofNullable(best);
    }

    /** The lowest bound that the state equation gives; one linear program. None for nets with more than some 20,000 places and transitions. */
    public Optional<MarkingBound> byStateEquation(int place) {
        if (LinearProgram.isTooLarge(incidence.columns().size(), net.placeCount())) {
            return Optional.empty();
        }
        LinearProgram program = new LinearProgram(net.placeCount(), millisLeft.getAsLong());
        for (int other = 0; other < net.placeCount(); other++) {
            program.cost(other, net.initial(other));
        }
        program.atLeast(IntegerVector.unit(place, 1), 1);
        incidence.columns().stream().filter(column -> !column.isZero()).forEach(column -> program.atMost(column, 0));
        Outcome outcome = program.solve();
        return outcome.solved()
                ? WholeMultiple.of(outcome.values(), weights -> weights.get(place) > 0 && incidence.neverGrows(weights))
                        .flatMap(this::bound)
                : Optional.empty();
    }

    /** The bound of weights that never grow; empty where its sum is too large to be counted. */
    private Optional<MarkingBound> bound(IntegerVector weights) {
        try {
            return Optional.of(MarkingBound.of(net, incidence, weights));
        } catch (ArithmeticException e) {
            return Optional.empty();
        }
    }
}
