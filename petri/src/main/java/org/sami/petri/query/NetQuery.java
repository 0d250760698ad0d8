package org.sami.petri.query;

import java.util.List;
import org.sami.petri.query.QueryAnswer.NetVerdict;

/** A question about the reachable markings of a net. Immutable. */
public sealed interface NetQuery {
    /** Whether an answer says that a rule is broken: an invariant, a deadlock, a run that cannot come home, a place without bound. */
    default boolean isFault(NetVerdict verdict) {
        return this instanceof Deadlock
                ? verdict == NetVerdict.YES
                : verdict == NetVerdict.NO && !(this instanceof Reachable);
    }

    /** Is there a reachable marking that fulfils a condition? */
    record Reachable(MarkingCondition condition) implements NetQuery {}

    /** Do all reachable markings fulfil a condition? */
    record Invariant(MarkingCondition condition) implements NetQuery {}

    /** Can a marking that fulfils a condition be reached from every reachable marking: can every run still come there? */
    record Home(MarkingCondition condition) implements NetQuery {}

    /** Is there a reachable marking in which no transition is enabled, and which is no end by a condition? */
    record Deadlock(MarkingCondition end) implements NetQuery {}

    /** How many tokens does a place have at most? */
    record Bound(int place) implements NetQuery {}

    /**
     * How much is a weighted sum of tokens at most?
     *
     * @param text of the sum, for the answer
     */
    record BoundOfSum(List<LinearComparison.Term> terms, long constant, String text) implements NetQuery {
        public BoundOfSum {
            terms = List.copyOf(terms);
        }

        /** The sum in a marking. */
        public long of(int[] marking) {
            long sum = constant;
            for (LinearComparison.Term term : terms) {
                sum += (long) term.factor() * marking[term.place()];
            }
            return sum;
        }
    }
}
