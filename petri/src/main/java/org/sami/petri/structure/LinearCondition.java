package org.sami.petri.structure;

import java.util.ArrayList;
import java.util.List;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/** What may hold of a marking: sums of tokens that reach a number, and "all of" and "one of" such conditions. Not-conditions are written as their opposites. */
public sealed interface LinearCondition {

    /** Whether a marking fulfils the condition. */
    boolean holds(int[] marking);

    /** The weighted sum of tokens is {@code least} or more. */
    record AtLeast(IntegerVector weights, long least) implements LinearCondition {
        @Override
        public boolean holds(int[] marking) {
            return weights.times(marking) >= least;
        }
    }

    /** Every one of the parts holds; true where there are none. */
    record AllOf(List<LinearCondition> parts) implements LinearCondition {
        public AllOf {
            parts = List.copyOf(parts);
        }

        @Override
        public boolean holds(int[] marking) {
            return parts.stream().allMatch(part -> part.holds(marking));
        }
    }

    /** One of the parts holds; false where there are none. */
    record OneOf(List<LinearCondition> parts) implements LinearCondition {
        public OneOf {
            parts = List.copyOf(parts);
        }

        @Override
        public boolean holds(int[] marking) {
            return parts.stream().anyMatch(part -> part.holds(marking));
        }
    }

    /** A place has so many tokens or more. */
    static AtLeast atLeast(int place, long tokens) {
        return new AtLeast(IntegerVector.unit(place, 1), tokens);
    }

    /** A place has so many tokens or fewer. */
    static AtLeast atMost(int place, long tokens) {
        return new AtLeast(IntegerVector.unit(place, -1), -tokens);
    }

    /** A transition is enabled. */
    static LinearCondition enabled(PetriNet net, int transition) {
        List<LinearCondition> parts = new ArrayList<>();
        ArcTable consumed = net.consumed();
        for (int arc = consumed.from(transition); arc < consumed.to(transition); arc++) {
            parts.add(atLeast(consumed.node(arc), consumed.weight(arc)));
        }
        ArcTable inhibitors = net.inhibitors();
        for (int arc = inhibitors.from(transition); arc < inhibitors.to(transition); arc++) {
            parts.add(atMost(inhibitors.node(arc), inhibitors.weight(arc) - 1L));
        }
        return new AllOf(parts);
    }

    /** No transition is enabled. */
    static LinearCondition dead(PetriNet net) {
        List<LinearCondition> disabled = new ArrayList<>();
        for (int transition = 0; transition < net.transitionCount(); transition++) {
            disabled.add(opposite(enabled(net, transition)));
        }
        return new AllOf(disabled);
    }

    /** The condition that holds exactly where another does not. */
    static LinearCondition opposite(LinearCondition condition) {
        if (condition instanceof AtLeast sum) {
            return new AtLeast(IntegerVector.ZERO.combined(1, sum.weights(), -1), Math.subtractExact(1, sum.least()));
        }
        if (condition instanceof AllOf all) {
            return new OneOf(all.parts().stream().map(LinearCondition::opposite).toList());
        }
        OneOf one = (OneOf) condition;
        return new AllOf(one.parts().stream().map(LinearCondition::opposite).toList());
    }
}
