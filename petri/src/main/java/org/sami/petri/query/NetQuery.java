package org.sami.petri.query;

/** A question about the reachable markings of a net. Immutable. */
public sealed interface NetQuery {
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
}
