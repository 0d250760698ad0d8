package org.sami.petri.query;

import java.util.List;
import org.sami.petri.graph.MarkingTest;
import org.sami.petri.net.FiringRule;
import org.sami.petri.net.PetriNet;

/** A condition on markings, as a tree: comparisons of sums of tokens, enabled transitions, deadlocks, and their combinations. Immutable. */
public sealed interface MarkingCondition extends MarkingTest
        permits LinearComparison,
                MarkingCondition.All,
                MarkingCondition.Any,
                MarkingCondition.Not,
                MarkingCondition.Enabled,
                MarkingCondition.NothingEnabled {

    /** Each of some conditions holds; with none of them, every marking fulfils it. */
    record All(List<MarkingCondition> parts) implements MarkingCondition {
        public All {
            parts = List.copyOf(parts);
        }

        @Override
        public boolean test(int[] marking) {
            for (MarkingCondition part : parts) {
                if (!part.test(marking)) {
                    return false;
                }
            }
            return true;
        }
    }

    /** At least one of some conditions holds; with none of them, no marking fulfils it. */
    record Any(List<MarkingCondition> parts) implements MarkingCondition {
        public Any {
            parts = List.copyOf(parts);
        }

        @Override
        public boolean test(int[] marking) {
            for (MarkingCondition part : parts) {
                if (part.test(marking)) {
                    return true;
                }
            }
            return false;
        }
    }

    /** A condition does not hold. */
    record Not(MarkingCondition part) implements MarkingCondition {
        @Override
        public boolean test(int[] marking) {
            return !part.test(marking);
        }
    }

    /** A transition is enabled. */
    record Enabled(PetriNet net, int transition) implements MarkingCondition {
        @Override
        public boolean test(int[] marking) {
            return FiringRule.isEnabled(net, transition, marking);
        }
    }

    /** No transition is enabled. */
    record NothingEnabled(PetriNet net) implements MarkingCondition {
        @Override
        public boolean test(int[] marking) {
            for (int t = 0; t < net.transitionCount(); t++) {
                if (FiringRule.isEnabled(net, t, marking)) {
                    return false;
                }
            }
            return true;
        }
    }
}
