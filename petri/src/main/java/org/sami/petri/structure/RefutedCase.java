package org.sami.petri.structure;

import java.util.ArrayList;
import java.util.List;
import org.sami.petri.net.PetriNet;
import org.sami.petri.structure.LinearCondition.AtLeast;

/**
 * Conditions that no reachable marking fulfils together, with the whole numbers that prove it (Farkas' lemma): the conditions, each as often as its factor says, ask that
 * a weighted sum of tokens is larger than it can become.
 *
 * @param conditions the conditions, those by which cases were distinguished and traps that stay marked included
 * @param traps which of the conditions say of a trap that it stays marked
 * @param limits numbers of firings by which cases were distinguished
 * @param factors first of the conditions, then of the places (each has 0 tokens or more), then of the limits; none is negative
 */
record RefutedCase(List<AtLeast> conditions, List<AtLeast> traps, List<FiringLimit> limits, IntegerVector factors) {
    RefutedCase {
        conditions = List.copyOf(conditions);
        traps = List.copyOf(traps);
        limits = List.copyOf(limits);
    }

    /** Whether the numbers prove it; exact. */
    boolean isProof(PetriNet net, Incidence incidence) {
        for (int i = 0; i < factors.size(); i++) {
            if (factors.valueAt(i) < 0) {
                return false;
            }
        }
        IntegerVector weights = weights(net);
        long room = Math.subtractExact(weights.times(net.initialMarking()), needed());
        IntegerVector firings = IntegerVector.ZERO;
        for (int i = 0; i < limits.size(); i++) {
            long factor = limitFactor(net, i);
            room = Math.subtractExact(
                    room, Math.multiplyExact(factor, limits.get(i).bound()));
            firings = firings.combined(1, limits.get(i).row(), factor);
        }
        for (int column = 0; column < incidence.columns().size(); column++) {
            long growth = weights.times(incidence.columns().get(column));
            if (Math.addExact(growth, firings.get(column)) > 0) {
                return false;
            }
        }
        return room < 0;
    }

    /** The weights of places of the sum that cannot become so large. */
    IntegerVector weights(PetriNet net) {
        IntegerVector weights = IntegerVector.ZERO;
        for (int i = 0; i < conditions.size(); i++) {
            weights = weights.combined(1, conditions.get(i).weights(), factors.get(i));
        }
        for (int place = 0; place < net.placeCount(); place++) {
            long factor = factors.get(conditions.size() + place);
            if (factor != 0) {
                weights = weights.combined(1, IntegerVector.unit(place, 1), factor);
            }
        }
        return weights;
    }

    /** How large the sum is at least where the conditions hold. */
    long needed() {
        long needed = 0;
        for (int i = 0; i < conditions.size(); i++) {
            needed = Math.addExact(
                    needed, Math.multiplyExact(factors.get(i), conditions.get(i).least()));
        }
        return needed;
    }

    boolean usesLimits(PetriNet net) {
        for (int i = 0; i < limits.size(); i++) {
            if (limitFactor(net, i) != 0) {
                return true;
            }
        }
        return false;
    }

    private long limitFactor(PetriNet net, int limit) {
        return factors.get(conditions.size() + net.placeCount() + limit);
    }

    /** For people: the sum, its bound and what the marking would need. */
    String words(PetriNet net, Incidence incidence) {
        IntegerVector weights = weights(net);
        List<String> assumed = new ArrayList<>();
        for (int i = 0; i < conditions.size(); i++) {
            if (factors.get(i) > 0 && traps.contains(conditions.get(i))) {
                assumed.add(conditions.get(i).weights().words(net::placeName) + " never becomes 0 (a marked trap)");
            }
        }
        if (!usesLimits(net)) {
            assumed.add(
                    weights.isZero()
                            ? "the marking asked for contradicts itself"
                            : MarkingBound.of(net, incidence, weights).words(net) + "; the marking asked for needs "
                                    + needed());
            return String.join("; ", assumed);
        }
        limits.forEach(limit -> assumed.add("where " + limit.words(net, incidence)));
        assumed.add(
                weights.words(net::placeName) + " stays below the " + needed() + " that the marking asked for needs");
        return String.join(", ", assumed);
    }
}
