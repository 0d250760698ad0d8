package org.sami.petri.structure;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.sami.petri.net.PetriNet;
import org.sami.petri.structure.LinearCondition.AllOf;
import org.sami.petri.structure.LinearCondition.AtLeast;
import org.sami.petri.structure.LinearCondition.OneOf;
import org.sami.petri.structure.LinearProgram.Outcome;

/**
 * Proves that no reachable marking fulfils a condition. Cases are distinguished until each contradicts the state equation: which part of a "one of" holds, that a trap
 * which is marked at first stays marked, and whether a transition fires at most or more than so many times. Each contradiction is a {@link RefutedCase}, exact in whole
 * numbers. Where no proof is found the question is open: the condition may be reachable or not. For one thread.
 *
 * <p>Source: Esparza and Melzer, "Verification of safety properties using integer programming: beyond the state equation", Formal Methods in System Design 16, 2000.
 */
public final class StateEquation {
    private static final double TOLERANCE = 1e-6;
    private static final long MOST_COUNT = 1_000_000;

    private final PetriNet net;
    private final StructureLimits limits;
    private final Incidence incidence;
    private final ClosedPlaces traps;
    private final InvariantSet invariants;
    private final List<RefutedCase> refuted = new ArrayList<>();
    private int programs;

    /** What is assumed in a case, and the choices that are still open in it. */
    private record Case(List<AtLeast> conditions, List<AtLeast> traps, List<FiringLimit> limits, List<OneOf> choices) {
        Case with(LinearCondition condition) {
            Case more = new Case(new ArrayList<>(conditions), traps, limits, new ArrayList<>(choices));
            more.add(condition);
            return more;
        }

        private void add(LinearCondition condition) {
            if (condition instanceof AtLeast sum) {
                conditions.add(sum);
            } else if (condition instanceof AllOf all) {
                all.parts().forEach(this::add);
            } else if (condition instanceof OneOf one && one.parts().size() == 1) {
                add(one.parts().get(0));
            } else {
                choices.add((OneOf) condition);
            }
        }

        Case withMarked(BitSet trap) {
            AtLeast marked = new AtLeast(IntegerVector.ones(trap), 1);
            List<AtLeast> more = new ArrayList<>(traps);
            more.add(marked);
            return new Case(conditions, more, limits, choices).with(marked);
        }

        Case with(FiringLimit limit) {
            List<FiringLimit> more = new ArrayList<>(limits);
            more.add(limit);
            return new Case(conditions, traps, more, choices);
        }

        Case without(OneOf choice) {
            List<OneOf> left = new ArrayList<>(choices);
            left.remove(choice);
            return new Case(conditions, traps, limits, left);
        }
    }

    private StateEquation(PetriNet net, InvariantSet invariants, StructureLimits limits) {
        this.net = net;
        this.limits = limits;
        this.invariants = invariants;
        this.incidence = Incidence.of(net);
        this.traps = ClosedPlaces.traps(net);
    }

    /**
     * Proves that no reachable marking fulfils a condition.
     *
     * @param invariants P-invariants of the net, which are tried before linear programs
     * @return the proof; empty where none was found
     */
    public static Optional<Refutation> refute(
            PetriNet net, LinearCondition condition, InvariantSet invariants, StructureLimits limits) {
        StateEquation search = new StateEquation(net, invariants, limits);
        Case whole = new Case(List.of(), List.of(), List.of(), List.of()).with(condition);
        try {
            return search.contradicts(whole)
                    ? Optional.of(new Refutation(search.refuted, search.programs > 0, net, search.incidence))
                    : Optional.empty();
        } catch (ArithmeticException e) {
            return Optional.empty(); // its numbers are too large to be checked
        }
    }

    private boolean contradicts(Case assumed) {
        FarkasSystem system = new FarkasSystem(
                net, incidence, assumed.conditions(), assumed.traps(), assumed.limits(), limits.millisLeft());
        Optional<RefutedCase> quick = InvariantRefuter.refute(net, incidence, invariants, system, assumed.conditions());
        if (quick.isPresent()) {
            refuted.add(quick.get());
            return true;
        }
        if (programs >= limits.programs()
                || system.isTooLarge()
                || limits.cancelled().getAsBoolean()) {
            return false;
        }
        programs++;
        Outcome outcome = system.counts();
        if (!outcome.solved()) {
            Optional<RefutedCase> proof = system.proof();
            proof.ifPresent(refuted::add);
            return proof.isPresent();
        }
        return split(assumed, outcome.values(), system.tokens(outcome.values()));
    }

    /** Excludes a solution of the equation that is no marking, or no whole one; false where that cannot be done. */
    private boolean split(Case assumed, double[] counts, double[] tokens) {
        Optional<OneOf> choice = assumed.choices().stream()
                .filter(open -> !nearlyHolds(open, tokens))
                .min(Comparator.comparingInt(open -> open.parts().size()));
        if (choice.isPresent()) {
            Case rest = assumed.without(choice.get());
            return choice.get().parts().stream().allMatch(part -> contradicts(rest.with(part)));
        }
        BitSet trap = markedTrapThatIsEmpty(tokens);
        if (!trap.isEmpty()) {
            return contradicts(assumed.withMarked(trap));
        }
        int column = mostFractional(counts);
        if (column < 0) {
            return false;
        }
        long below = (long) Math.floor(counts[column]);
        return contradicts(assumed.with(new FiringLimit(column, false, below)))
                && contradicts(assumed.with(new FiringLimit(column, true, below + 1)));
    }

    private BitSet markedTrapThatIsEmpty(double[] tokens) {
        BitSet empty = new BitSet();
        for (int place = 0; place < tokens.length; place++) {
            empty.set(place, tokens[place] < TOLERANCE);
        }
        BitSet trap = traps.greatestWithin(empty);
        return trap.stream().anyMatch(place -> net.initial(place) > 0) ? trap : new BitSet();
    }

    private static int mostFractional(double[] counts) {
        int best = -1;
        double farthest = TOLERANCE;
        for (int i = 0; i < counts.length; i++) {
            double off = Math.abs(counts[i] - Math.rint(counts[i]));
            if (off > farthest && counts[i] < MOST_COUNT) {
                farthest = off;
                best = i;
            }
        }
        return best;
    }

    private static boolean nearlyHolds(LinearCondition condition, double[] tokens) {
        if (condition instanceof AllOf all) {
            return all.parts().stream().allMatch(part -> nearlyHolds(part, tokens));
        }
        if (condition instanceof OneOf one) {
            return one.parts().stream().anyMatch(part -> nearlyHolds(part, tokens));
        }
        AtLeast sum = (AtLeast) condition;
        double total = 0;
        for (int i = 0; i < sum.weights().size(); i++) {
            total += sum.weights().valueAt(i) * tokens[sum.weights().indexAt(i)];
        }
        return total >= sum.least() - TOLERANCE;
    }
}
